import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { ALL_LEVELS } from '../../core/link/link.ts';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { choice, toggle } from './choice.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';

/** Names of the levels of a tree, as the switches say them: trunk, and what is drawn besides. */
const levelNames = ['Trunk', 'Limbs', 'Branches', 'Twigs'];

/** What grows: species, seed, levels. */
class GrowPanel extends Part {
  protected override render(): TemplateResult {
    return html`${this.species()}${this.seed()}${this.levels()}`;
  }

  private species(): TemplateResult {
    const { doc, session, editor } = this;
    const own = doc.ownSpecies === null ? null : (session.tree?.species.name ?? 'Your species');
    const options = [
      ...session.species.map((s) => ({
        value: s.id,
        label: html`<span class="name">${s.name}</span><i class="latin" lang="la">${s.latin}</i>`,
      })),
      ...(own === null
        ? []
        : [{ value: '', label: html`<span class="name">${own}</span><i class="latin">your file</i>` }]),
    ];
    return html`${choice({
      name: 'species',
      legend: 'Species',
      value: own === null ? doc.species : '',
      options,
      onChoose: (id) => id && editor.actions.setSpecies(id),
    })}
    <label class="button open-file">${icon('open')}<span>Open a species file…</span>
      <input type="file" accept=".json,application/json" class="spoken" @change=${this.open}></label>`;
  }

  private open(event: Event): void {
    const input = event.target as HTMLInputElement;
    const file = input.files?.[0];
    if (file) this.dispatchEvent(new CustomEvent('own-file', { detail: file, bubbles: true }));
    input.value = ''; // the same file can be chosen again after it was mended
  }

  private seed(): TemplateResult {
    const { doc, editor } = this;
    const { min, max } = LINK_NUMBERS.seed;
    const typed = (event: Event): void => {
      const box = event.target as HTMLInputElement;
      if (box.value !== '' && box.validity.valid) editor.actions.setSeed(box.valueAsNumber);
      else box.value = String(doc.seed);
    };
    return html`<div class="seed">
      <label for="seed" title="Same species, same seed: the same tree, everywhere">Seed</label>
      <input type="number" id="seed" min=${min} max=${max} step="1" .value=${live(String(doc.seed))} @change=${typed}>
      <button type="button" class="quiet" @click=${() => editor.actions.rollSeed()} title="Another tree (D)">
        ${icon('dice')}<span>Another</span></button>
    </div>`;
  }

  private levels(): TemplateResult {
    const { doc, session, editor } = this;
    const count = session.tree?.figures.levels ?? 3;
    const options = Array.from({ length: count }, (_, i) => ({
      value: String(i + 1),
      label: html`<span class="chip" data-level=${Math.min(i, 3)}></span>${levelNames[i] ?? `Level ${i}`}`,
      title: i === 0 ? 'Draw the trunk alone (1)' : `Draw level 0 to ${i} (${i + 1})`,
    }));
    const shown = Math.min(doc.levelsShown, count);
    return html`<div class="part">${choice({
      name: 'levels',
      legend: 'Draw as far as',
      value: String(shown),
      options,
      onChoose: (value) => editor.actions.setLevels(Number(value) >= count ? ALL_LEVELS : Number(value)),
    })}
    ${toggle(
      'leaves',
      shown < count ? 'Leaves: with all levels' : 'Leaves',
      doc.showLeaves,
      (on) => editor.actions.setShowLeaves(on),
      { title: 'Draw the leaves (L)', disabled: shown < count },
    )}</div>`;
  }
}

customElements.define('wg-grow', GrowPanel);
