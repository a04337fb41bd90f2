import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import type { Species } from '../../core/species/species.ts';
import { VARIANTS } from '../../core/species/variety.ts';
import { Part } from '../ui/panel.ts';
import { varietyWords } from '../words/variety.ts';
import { Portraits } from './portraits.ts';
import { presentSpecies } from './present.ts';
import { CARD, treeGrid } from './tree-grid.ts';

/** The seed with which the last page of seeds begins. */
const LAST = Math.floor(LINK_NUMBERS.seed.max / VARIANTS) * VARIANTS;

/** Twelve seeds of the present species: pages of seeds that follow each other, the first with the present one in it. */
class SeedsTab extends Part {
  private readonly portraits = new Portraits(
    (size, grown, species) => this.editor.picture.portrait(grown, species, size),
    () => this.requestUpdate(),
  );
  /** Seed of the first card. */
  private first = 0;
  private chosen: number | null = null;
  private shown: { readonly species: Species; readonly first: number; readonly theme: string | undefined } | null =
    null;

  override connectedCallback(): void {
    super.connectedCallback();
    const { seed } = this.doc;
    this.first = Math.min(LAST, seed - (seed % VARIANTS));
    this.chosen = seed - this.first;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.portraits.dispose();
    this.shown = null;
  }

  protected override willUpdate(changes: PropertyValues): void {
    super.willUpdate(changes);
    const species = presentSpecies(this.editor);
    if (!species) return;
    const { theme } = document.documentElement.dataset;
    const { shown, first } = this;
    if (shown && shown.first === first && shown.theme === theme && sameSpecies(shown.species, species)) return;
    this.shown = { species, first, theme };
    this.portraits.show(
      Array.from({ length: VARIANTS }, (_, i) => ({ species, seed: first + i })),
      CARD,
    );
  }

  protected override render(): TemplateResult | typeof nothing {
    const { shown, first, portraits } = this;
    const words = varietyWords.seeds;
    if (!shown) return html`<p class="soft">${varietyWords.noTree}</p>`;
    const name = this.doc.treeName ?? shown.species.name;
    const now = this.doc.seed - first;
    const done = portraits.list.filter((p) => p.url !== null || p.failed !== null).length;
    return html`<form class="variety-tab" @submit=${this.take}>
      <p class="soft">${words.intro}</p>
      ${treeGrid({
        name: 'variety-seed',
        legend: words.grid,
        portraits,
        captions: portraits.list.map(({ seed }) => ({
          shown: varietyWords.seed(seed),
          spoken: varietyWords.tree(name, seed),
        })),
        chosen: this.chosen,
        now: now >= 0 && now < VARIANTS ? now : null,
        onChoose: (index) => {
          this.chosen = index;
          this.requestUpdate();
        },
        onTake: () => this.take(),
      })}
      <footer class="variety-foot">
        <button type="button" class="quiet" ?disabled=${first === 0} @click=${() => this.turn(-1)}>${words.before}</button>
        <button type="button" class="quiet" ?disabled=${first >= LAST} @click=${() => this.turn(1)}>${words.others}</button>
        <span class="soft variety-progress">${portraits.idle ? nothing : varietyWords.drawing(done, VARIANTS)}</span>
        <button type="submit" class="primary" ?disabled=${this.chosen === null}>${words.take}</button>
      </footer></form>`;
  }

  private turn(pages: number): void {
    this.first = Math.min(LAST, Math.max(0, this.first + pages * VARIANTS));
    const now = this.doc.seed - this.first;
    this.chosen = now >= 0 && now < VARIANTS ? now : null;
    this.requestUpdate();
  }

  private readonly take = (event?: Event): void => {
    event?.preventDefault();
    if (this.chosen === null) return;
    const seed = this.first + this.chosen;
    const { actions } = this.editor;
    if (seed !== this.doc.seed) {
      actions.setSeed(seed);
      actions.say(varietyWords.took.seed(seed));
    }
    actions.closeDialog();
  };
}

/** Edits make a new species each time that they are asked for; what counts is what it says. */
const sameSpecies = (a: Species, b: Species): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);

customElements.define('wg-variety-seeds', SeedsTab);
