import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { SEASONS, type Season } from '../../core/species/season.ts';
import type { Species } from '../../core/species/species.ts';
import { publicUrl } from '../public-file.ts';
import type { SpeciesEntry } from '../session.ts';
import { differs } from '../species-picture.ts';
import { loadSpecies } from '../species-source.ts';
import { icon } from '../ui/icons.ts';
import { Part } from '../ui/panel.ts';
import { galleryWords } from '../words/gallery.ts';
import { speciesPageWords as words } from '../words/species-page.ts';
import type { Live } from './live.ts';
import { parametersTable } from './parameters-table.ts';
import { portrait } from './species-card.ts';
import { speciesFacts } from './species-facts.ts';

/** The page of a species: its portrait, what is known of it, its numbers, and what one can do with it. */
class SpeciesPage extends Part {
  static override properties = {
    ...Part.properties,
    entry: { attribute: false },
    season: { attribute: false },
    live: { attribute: false },
    moves: { attribute: false },
  };
  declare entry: SpeciesEntry;
  declare season: Season;
  declare live: Live;
  /** Its portrait is to move, or moves. */
  declare moves: boolean;
  private species: Species | null = null;
  private failed: string | null = null;
  private opened = false;
  private told: { readonly title: string; readonly snippet: string | null } | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.live.stop();
  }

  protected override willUpdate(changes: PropertyValues): void {
    super.willUpdate(changes);
    if (!changes.has('entry')) return;
    this.species = null;
    this.failed = null;
    this.told = null;
    void this.load(this.entry);
  }

  private async load(entry: SpeciesEntry): Promise<void> {
    try {
      const species = await loadSpecies(entry);
      if (entry === this.entry) this.species = species;
    } catch (error) {
      if (entry === this.entry) this.failed = error instanceof Error ? error.message : String(error);
    }
    this.requestUpdate();
  }

  protected override render(): TemplateResult {
    const { entry, season, moves, species } = this;
    const shown = differs(entry, season) ? season : 'summer';
    return html`<article class="species-sheet" @keydown=${this.onKey}>
      <nav class="species-turn">
        <button type="button" class="quiet" @click=${this.back}>${icon('undo')}<span>${words.back}</span></button>
        <span><button type="button" class="round" aria-label=${words.previous} title=${words.previous} @click=${() => this.turn(-1)}>${icon('up')}</button>
          <button type="button" class="round" aria-label=${words.next} title=${words.next} @click=${() => this.turn(1)}>${icon('down')}</button></span></nav>
      <figure class="species-portrait"><div class="species-plate" role="img" aria-label=${words.portrait(entry.name)}>${portrait(entry, shown, 'eager', '560px')}${moves ? html`<canvas class="glimpse" aria-hidden="true"></canvas>` : nothing}</div>
        ${this.seasons(shown)}</figure>
      <div class="species-text"><h3>${entry.name}</h3><p class="species-latin"><i lang="la">${entry.latin}</i></p>
        <div class="species-deeds">
          <button type="button" class="primary" autofocus @click=${() => this.editor.actions.takeSpecies(entry, shown)}>${words.edit}</button>
          <button type="button" class="quiet" @click=${() => void this.embed(shown)}>${icon('code')}<span>${words.embed}</span></button>
          <a class="button quiet" href=${publicUrl(`species/${entry.file}`).href} download=${entry.file}>${icon('save')}<span>${words.download}</span></a>
        </div>
        <div role="status" class="species-told">${
          this.told
            ? html`<p>${this.told.title}</p>${this.told.snippet === null ? nothing : html`<textarea readonly rows="4" aria-label=${words.embed} .value=${this.told.snippet}></textarea>`}`
            : nothing
        }</div>
        ${species ? this.content(species) : html`<p class="soft" role=${this.failed === null ? nothing : 'alert'}>${this.failed === null ? words.loading : galleryWords.failed(this.failed)}</p>`}
      </div></article>`;
  }

  protected override updated(changes: PropertyValues): void {
    super.updated(changes);
    if (changes.has('entry')) {
      this.closest('.dialog-body')?.scrollTo(0, 0);
      const before = changes.get('entry') as SpeciesEntry | undefined;
      if (!before) this.querySelector<HTMLElement>('.species-deeds .primary')?.focus({ preventScroll: true });
    }
    this.live.wish(this.entry, this.season);
    this.live.follow(this);
  }

  private seasons(shown: Season): TemplateResult | typeof nothing {
    const { entry } = this;
    if (!entry.seasons?.length) return nothing;
    return html`<div class="species-seasons" role="group" aria-label=${words.seasons}>${SEASONS.filter(
      (season) => season === 'summer' || differs(entry, season),
    ).map(
      (season) => html`<button type="button" aria-pressed=${season === shown} @click=${() => this.setSeason(season)}
        aria-label=${words.inSeason(entry.name, galleryWords.seasons[season])}>${portrait(entry, season, 'lazy', '132px')}<span>${galleryWords.seasons[season]}</span></button>`,
    )}</div>`;
  }

  private content(species: Species): TemplateResult {
    return html`${species.description ? html`<p class="species-says">${species.description}</p>` : nothing}
      ${speciesFacts(species)}
      <details class="species-numbers" @toggle=${(e: Event) => {
        this.opened = (e.currentTarget as HTMLDetailsElement).open;
        this.requestUpdate();
      }}><summary>${words.parameters}</summary>${this.opened ? parametersTable(species) : nothing}</details>`;
  }

  private setSeason(season: Season): void {
    this.live.stop();
    this.dispatchEvent(new CustomEvent('season', { detail: season }));
  }

  private readonly back = (): void => this.editor.actions.showSpeciesPage(null);

  private turn(by: number): void {
    this.live.stop();
    this.dispatchEvent(new CustomEvent('turn', { detail: by }));
  }

  /** Escape goes back among all first; the next one closes the gallery. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    this.back();
  };

  private async embed(season: Season): Promise<void> {
    const { entry } = this;
    const snippet = await this.editor.actions.copySpeciesEmbed(entry, season);
    if (entry !== this.entry) return;
    this.told = { title: snippet === null ? words.copied : words.shown, snippet };
    this.requestUpdate();
  }
}

customElements.define('wg-species', SpeciesPage);
