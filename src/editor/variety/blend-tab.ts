import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { blend } from '../../core/species/blend.ts';
import { editSpecies, valueAt } from '../../core/species/edits.ts';
import type { Species } from '../../core/species/species.ts';
import type { SpeciesEntry } from '../session.ts';
import { loadSpecies } from '../species-source.ts';
import { numberField } from '../ui/number-field.ts';
import { Part } from '../ui/panel.ts';
import { varietyWords } from '../words/variety.ts';
import { Portraits, RESTS, type Size } from './portraits.ts';
import { presentSpecies } from './present.ts';
import { treePicture } from './tree-card.ts';

/** Pixels of the large picture, and of those of the two parents. */
const LARGE: Size = { width: 720, height: 720 };
const SMALL: Size = { width: 240, height: 300 };

/** Two species and what lies between them: the blend is taken as a species of its own. */
class BlendTab extends Part {
  private readonly draw = (...[size, grown, species]: Parameters<ConstructorParameters<typeof Portraits>[0]>) =>
    this.editor.picture.portrait(grown, species, size);
  private readonly child = new Portraits(this.draw, () => this.requestUpdate());
  private readonly parents = new Portraits(this.draw, () => this.requestUpdate());
  private present: Species | null = null;
  private other: { readonly id: string; readonly species: Species } | null = null;
  private t = 0.5;
  private resting: ReturnType<typeof setTimeout> | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.present = presentSpecies(this.editor);
    const first = this.choices().find((s) => s.id === this.other?.id) ?? this.choices()[0];
    if (first) void this.choose(first.id);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.resting);
    this.child.dispose();
    this.parents.dispose();
  }

  /** All that ship but the one that is there. */
  private choices(): readonly SpeciesEntry[] {
    const { species, ownSpecies } = this.doc;
    return this.session.species.filter((s) => ownSpecies !== null || s.id !== species);
  }

  protected override render(): TemplateResult {
    const words = varietyWords.blend;
    const { present, other } = this;
    const blended = this.blended();
    if (!present) return html`<p class="soft">${varietyWords.noTree}</p>`;
    const { locks } = this.session;
    const [own, far] = this.parents.list;
    return html`<form class="variety-tab blend" @submit=${this.take}>
      <p class="soft">${words.intro}</p>
      <figure class="blend-child" aria-label=${words.preview(blended?.name ?? '')}>
        ${this.child.list[0] ? treePicture(this.child.list[0], this.child.frame, LARGE) : html`<span class="tree-picture"></span>`}
        <figcaption>${blended ? oneWord(blended.name) : words.loading}</figcaption></figure>
      <div class="blend-between">
        <div class="blend-parent">${own ? treePicture(own, this.parents.frame, SMALL) : nothing}<span>${present.name}</span></div>
        <div class="blend-choice">
          <label class="blend-other"><span>${words.other}</span>
            <select autofocus .value=${live(other?.id ?? '')} @change=${(e: Event) => void this.choose((e.target as HTMLSelectElement).value)}>
              ${this.choices().map((s) => html`<option value=${s.id} ?selected=${s.id === other?.id}>${s.name}</option>`)}</select></label>
          ${numberField({
            id: 'blend-share',
            label: words.share,
            unit: '%',
            value: Math.round(100 * this.t),
            min: 0,
            max: 100,
            step: 1,
            decimals: 0,
            reset: 50,
            onInput: (value) => this.setShare(value / 100),
          })}
          ${locks.size > 0 ? html`<p class="soft">${words.locked(locks.size)}</p>` : nothing}
        </div>
        <div class="blend-parent">${far ? treePicture(far, this.parents.frame, SMALL) : nothing}<span>${other?.species.name ?? words.loading}</span></div>
      </div>
      <footer class="variety-foot"><span class="variety-progress"></span>
        <button type="submit" class="primary" ?disabled=${!blended}>${words.take}</button></footer></form>`;
  }

  /** The species that would be taken; what is locked stays as it is. */
  private blended(): Species | null {
    const { present, other, t } = this;
    if (!present || !other) return null;
    const { locks } = this.session;
    const kept = Object.fromEntries([...locks].map((path) => [path, valueAt(present, path)]));
    return editSpecies(blend(present, other.species, t), kept);
  }

  private async choose(id: string): Promise<void> {
    const entry = this.session.species.find((s) => s.id === id);
    if (!entry) return;
    try {
      const species = await loadSpecies(entry);
      if (!this.isConnected) return;
      this.other = { id, species };
      const { present } = this;
      const { seed } = this.doc;
      if (present)
        this.parents.show(
          [present, species].map((s) => ({ species: s, seed })),
          SMALL,
        );
      this.look(false);
    } catch (error) {
      this.editor.actions.notify('error', error instanceof Error ? error.message : String(error));
      this.editor.actions.closeDialog();
    }
  }

  private look(draft: boolean): void {
    const species = this.blended();
    if (species) this.child.show([{ species, seed: this.doc.seed }], LARGE, draft);
    this.requestUpdate();
  }

  private setShare(t: number): void {
    this.t = t;
    this.look(true);
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.look(false), RESTS);
  }

  private readonly take = (event: Event): void => {
    event.preventDefault();
    const species = this.blended();
    if (!species) return;
    const { actions } = this.editor;
    actions.openSpecies(JSON.stringify(species));
    actions.say(varietyWords.took.blend(species.name));
    actions.closeDialog();
  };
}

/** The sign does not stand alone on a line. */
const oneWord = (name: string): string => name.replace(/ %$/, '\u00a0%');

customElements.define('wg-variety-blend', BlendTab);
