import { html, nothing, type PropertyValues, type TemplateResult } from 'lit';
import { editSpecies, editsBetween } from '../../core/species/edits.ts';
import type { Species } from '../../core/species/species.ts';
import { moreLikeThis, VARIANTS } from '../../core/species/variety.ts';
import { baseOf } from '../edited-tree.ts';
import { numberField } from '../ui/number-field.ts';
import { Part } from '../ui/panel.ts';
import { varietyWords } from '../words/variety.ts';
import { Portraits, RESTS } from './portraits.ts';
import { presentSpecies } from './present.ts';
import { CARD, treeGrid } from './tree-grid.ts';

/** One step of the way: the tree around which the variants stand, and which twelve they are. */
interface Round {
  readonly from: Species;
  readonly draw: number;
}

/** Twelve variants around a tree; one of them may be the next around which they stand. What is taken is one change of the document. */
class LikeTab extends Part {
  private readonly portraits = new Portraits(
    (size, grown, species) => this.editor.picture.portrait(grown, species, size),
    () => this.requestUpdate(),
  );
  private rounds: readonly Round[] = [];
  private amount = 0.6;
  private chosen: number | null = null;
  private shown: { readonly round: Round; readonly amount: number; readonly theme: string | undefined } | null = null;
  /** A slider is being dragged: sketches alone. */
  private draft = false;
  private resting: ReturnType<typeof setTimeout> | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    // Every visit begins at the tree that is there.
    this.rounds = [];
    this.chosen = null;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.resting);
    this.draft = false;
    this.portraits.dispose();
    this.shown = null;
  }

  protected override willUpdate(changes: PropertyValues): void {
    super.willUpdate(changes);
    const present = presentSpecies(this.editor);
    if (!present) return;
    if (this.rounds.length === 0) this.rounds = [{ from: present, draw: this.doc.seed }];
    const { theme } = document.documentElement.dataset;
    const round = this.rounds.at(-1)!;
    const { shown, amount } = this;
    if (shown && shown.round === round && shown.amount === amount && shown.theme === theme) return;
    this.shown = { round, amount, theme };
    const variants = moreLikeThis(round.from, round.draw, amount, this.session.locks);
    this.portraits.show(
      variants.map((edits) => ({ species: editSpecies(round.from, edits), seed: this.doc.seed })),
      CARD,
      this.draft,
    );
  }

  protected override render(): TemplateResult {
    const { rounds, portraits, chosen } = this;
    const words = varietyWords.like;
    if (rounds.length === 0) return html`<p class="soft">${varietyWords.noTree}</p>`;
    const done = portraits.list.filter((p) => p.url !== null || p.failed !== null).length;
    return html`<form class="variety-tab" @submit=${this.take}>
      <div class="variety-head"><p class="soft">${words.intro}</p>${numberField({
        id: 'variety-amount',
        label: words.amount,
        unit: '%',
        help: words.amountHelp,
        value: Math.round(100 * this.amount),
        min: 5,
        max: 100,
        step: 5,
        decimals: 0,
        reset: 60,
        onInput: (value) => this.setAmount(value / 100),
      })}</div>
      ${treeGrid({
        name: 'variety-like',
        legend: words.grid,
        portraits,
        captions: portraits.list.map((_, i) => ({
          shown: varietyWords.number(i + 1),
          spoken: varietyWords.variant(i + 1),
        })),
        chosen,
        now: null,
        onChoose: (index) => {
          this.chosen = index;
          this.requestUpdate();
        },
        onTake: () => this.take(),
      })}
      <footer class="variety-foot">
        <button type="button" class="quiet" ?disabled=${rounds.length < 2} @click=${this.back}>${words.back}</button>
        <button type="button" class="quiet" @click=${this.others}>${words.others}</button>
        <button type="button" class="quiet" ?disabled=${chosen === null} @click=${this.goOn}>${words.on}</button>
        <span class="soft variety-progress">${portraits.idle || this.draft ? nothing : varietyWords.drawing(done, VARIANTS)}</span>
        <button type="submit" class="primary" ?disabled=${chosen === null}>${words.take}</button>
      </footer></form>`;
  }

  private setAmount(amount: number): void {
    this.draft = true;
    this.amount = amount;
    this.chosen = null;
    this.requestUpdate();
    clearTimeout(this.resting);
    this.resting = setTimeout(() => {
      this.draft = false;
      this.shown = null;
      this.requestUpdate();
    }, RESTS);
  }

  private go(rounds: readonly Round[]): void {
    this.rounds = rounds;
    this.chosen = null;
    this.requestUpdate();
  }

  private readonly others = (): void => {
    const last = this.rounds.at(-1)!;
    this.go([...this.rounds.slice(0, -1), { ...last, draw: last.draw + VARIANTS }]);
  };

  private readonly goOn = (): void => {
    const from = this.chosen === null ? undefined : this.portraits.list[this.chosen]?.species;
    if (from) this.go([...this.rounds, { from, draw: this.rounds.at(-1)!.draw + 1 }]);
  };

  private readonly back = (): void => this.go(this.rounds.slice(0, -1));

  private readonly take = (event?: Event): void => {
    event?.preventDefault();
    const { actions, document, session } = this.editor;
    const chosen = this.chosen === null ? undefined : this.portraits.list[this.chosen]?.species;
    const present = presentSpecies(this.editor);
    if (!chosen || !present || !baseOf(document, session)) return;
    actions.setParameters(editsBetween(present, chosen));
    actions.say(varietyWords.took.variant);
    actions.closeDialog();
  };
}

customElements.define('wg-variety-like', LikeTab);
