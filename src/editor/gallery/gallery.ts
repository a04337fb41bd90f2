import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import '../styles/gallery.css';
import type { Season } from '../../core/species/season.ts';
import type { SpeciesKind } from '../../core/species/species.ts';
import type { SpeciesEntry } from '../session.ts';
import { Part } from '../ui/panel.ts';
import { galleryWords } from '../words/gallery.ts';
import { findSpecies, kindsOf } from './find-species.ts';
import { galleryFilters } from './gallery-filters.ts';
import { byArrows, enterGrid } from './grid-keys.ts';
import { Live } from './live.ts';
import { speciesCard } from './species-card.ts';

/** Milliseconds that a pointer rests on a picture before it begins to move: who passes by wakes nothing. */
const RESTS = 140;

/** All species as portraits that move under the pointer, and the page of each. */
class Gallery extends Part {
  private query = '';
  private kind: SpeciesKind | null = null;
  private season: Season = 'summer';
  /** The card that the arrows have come to: the one that Tab reaches. */
  private at: string | null = null;
  private live: Live | null = null;
  private resting: ReturnType<typeof setTimeout> | undefined;
  private pageBefore: string | null = null;
  /** The page of a species is loaded, or is on its way. */
  private paged = false;

  override connectedCallback(): void {
    super.connectedCallback();
    this.live = new Live(this.editor, () => this.requestUpdate());
    this.at = this.doc.ownSpecies === null ? this.doc.species : null;
    this.pageBefore = this.session.speciesPage;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.resting);
    this.live?.dispose();
    this.live = null;
  }

  /** What lies open, as long as there is such a species. */
  private get entry(): SpeciesEntry | undefined {
    return this.session.species.find(({ id }) => id === this.session.speciesPage);
  }

  protected override render(): TemplateResult {
    const { entry } = this;
    return html`<div class="gallery-all" ?hidden=${entry !== undefined}>${this.all()}</div>
      ${
        entry && this.live
          ? html`<wg-species .editor=${this.editor} .entry=${entry} .season=${this.season} .live=${this.live} .moves=${this.live.shows(entry.id)}
              @turn=${this.turn} @season=${(e: CustomEvent<Season>) => this.setSeason(e.detail)}></wg-species>`
          : nothing
      }`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    const { speciesPage } = this.session;
    const before = this.pageBefore;
    this.pageBefore = speciesPage;
    if (before !== null && speciesPage === null) {
      // Back among all, where one left.
      this.at = before;
      this.live?.stop();
      this.card(before)?.focus();
    } else if (before === null && speciesPage !== null) this.live?.stop();
    this.live?.follow(this);
    // Its page comes behind all species, or when it is asked for.
    if (this.session.panels || speciesPage !== null) void this.loadPage();
  }

  private async loadPage(): Promise<void> {
    if (this.paged) return;
    this.paged = true;
    try {
      await import('./species-page.ts');
    } catch (error) {
      this.paged = false;
      const reason = error instanceof Error ? error.message : String(error);
      this.editor.actions.notify('error', galleryWords.failed(reason));
    }
  }

  private all(): TemplateResult {
    const { species } = this.session;
    const words = galleryWords;
    if (species.length === 0) return html`<p class="soft">${words.empty}</p>`;
    const found = findSpecies(species, this.query, this.kind);
    const tabbed = found.some(({ id }) => id === this.at) ? this.at : (found[0]?.id ?? null);
    const now = this.doc.ownSpecies === null ? this.doc.species : null;
    return html`<p class="gallery-intro soft">${Live.wanted() ? (matchMedia('(hover: none)').matches ? words.introTouch : words.intro) : words.introStill}
        <a href="forest.html">${words.forest}</a> <a href="learn/index.html">${words.lessons}</a></p>
      ${galleryFilters({
        query: this.query,
        kind: this.kind,
        kinds: kindsOf(species),
        season: this.season,
        narrow: this.session.narrow,
        onQuery: (query) => this.set({ query }),
        onKind: (kind) => this.set({ kind }),
        onSeason: (season) => this.setSeason(season),
        onDown: () => enterGrid(this),
      })}
      <p class="gallery-count soft" role="status">${words.count(found.length, species.length)}</p>
      ${
        found.length === 0
          ? html`<div class="gallery-none"><p>${words.none}</p><p class="soft">${words.noneHint}</p>
            <button type="button" class="primary" @click=${this.showAll}>${words.showAll}</button></div>`
          : html`<ul class="gallery-grid" aria-label=${words.list} @keydown=${byArrows} @focusin=${this.onFocus} @focusout=${this.rest}>${found.map(
              (entry) =>
                speciesCard({
                  entry,
                  season: this.season,
                  tabbed: entry.id === tabbed,
                  now: entry.id === now,
                  live: this.session.speciesPage === null && this.live?.shows(entry.id) === true,
                  onOpen: () => this.editor.actions.showSpeciesPage(entry.id),
                  onPoint: (on) => (on ? this.wake(entry) : this.rest()),
                }),
            )}</ul>`
      }`;
  }

  private set(change: { query?: string; kind?: SpeciesKind | null }): void {
    Object.assign(this, change);
    this.requestUpdate();
  }

  /** The button that was pressed goes; one looks on where one looked for it. */
  private readonly showAll = async (): Promise<void> => {
    this.set({ query: '', kind: null });
    await this.updateComplete;
    this.querySelector<HTMLElement>('.gallery-search input')?.focus();
  };

  private setSeason(season: Season): void {
    this.season = season;
    this.live?.stop();
    this.requestUpdate();
  }

  private card(id: string): HTMLElement | null {
    return this.querySelector<HTMLElement>(`.gallery-grid a[data-id="${id}"]`);
  }

  private readonly onFocus = (event: FocusEvent): void => {
    const card = event.target as HTMLElement;
    const entry = this.session.species.find(({ id }) => id === card.dataset.id);
    if (!entry) return;
    this.at = entry.id;
    // A finger that opens a page need not wake its picture first, nor does the page by itself.
    if (navigator.userActivation?.hasBeenActive !== false && card.matches(':focus-visible')) this.wake(entry);
    this.requestUpdate();
  };

  private wake(entry: SpeciesEntry): void {
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.live?.wish(entry, this.season), RESTS);
  }

  private readonly rest = (): void => {
    clearTimeout(this.resting);
    this.live?.stop();
  };

  /** To the species before or after the one that lies open, in the list as it is filtered now. */
  private readonly turn = (event: Event): void => {
    const { entry } = this;
    const found = findSpecies(this.session.species, this.query, this.kind);
    const list = found.some(({ id }) => id === entry?.id) ? found : this.session.species;
    const at = list.findIndex(({ id }) => id === entry?.id);
    const next = list[(at + (event as CustomEvent<number>).detail + list.length) % list.length];
    if (next) this.editor.actions.showSpeciesPage(next.id);
  };
}

customElements.define('wg-gallery', Gallery);
