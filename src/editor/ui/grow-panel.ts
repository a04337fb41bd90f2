import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { ALL_LEVELS } from '../../core/link/link.ts';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { thumbnailUrl } from '../species-picture.ts';
import { growWords } from '../words/grow.ts';
import { treeWords } from '../words/tree.ts';
import { choice, toggle } from './choice.ts';
import { icon } from './icons.ts';
import { Part } from './panel.ts';
import { unlessTyping } from './unless-typing.ts';
import './tree/tree-panel.ts';

/** What grows: species, seed, how far it is drawn, and every number of it. */
class GrowPanel extends Part {
  protected override render(): TemplateResult {
    return html`${this.species()}${this.seed()}${this.levels()}<wg-tree .editor=${this.editor}></wg-tree>`;
  }

  private species(): TemplateResult {
    const { doc, session, editor } = this;
    const own = doc.ownSpecies === null ? null : (session.tree?.species.name ?? growWords.ownSpecies);
    const now = own === null ? session.species.find((s) => s.id === doc.species) : undefined;
    const picture = now ? thumbnailUrl(now) : null;
    const choose = (event: Event): void => {
      const { value } = event.target as HTMLSelectElement;
      if (value) editor.actions.setSpecies(value);
    };
    return html`<div class="species-part">
      <button type="button" class="species-plate" aria-label=${growWords.all} title=${growWords.all} @click=${() => editor.actions.openGallery()}>${
        picture ? html`<img alt="" src=${picture} width="160" height="200">` : icon('leaf')
      }</button>
      <div class="species-choice"><label for="species">${growWords.species}</label>
        <select id="species" .value=${live(own === null ? doc.species : '')} @change=${choose}>
          ${own === null ? nothing : html`<option value="" selected>${own}</option>`}
          ${session.species.map((s) => html`<option value=${s.id} ?selected=${own === null && s.id === doc.species}>${s.name}</option>`)}</select>
        <p>${own === null ? html`<i lang="la">${now?.latin ?? nothing}</i>` : growWords.ownFile}</p>
        <div class="species-ways"><button type="button" class="quiet" @click=${() => editor.actions.openGallery()}>${growWords.all}</button>
          <label class="button open-file">${icon('open')}<span>${growWords.open}</span>
            <input type="file" accept=".json,.xml,application/json,text/xml" class="spoken" @change=${this.open}></label></div></div></div>`;
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
      <label for="seed" title=${growWords.seedHint}>${growWords.seed}</label>
      <input type="number" id="seed" min=${min} max=${max} step="1" .value=${unlessTyping(String(doc.seed))} @change=${typed}>
      <button type="button" class="quiet" @click=${() => editor.actions.rollSeed()} title=${growWords.anotherHint}>
        ${icon('dice')}<span>${growWords.another}</span></button>
    </div>`;
  }

  private levels(): TemplateResult {
    const { doc, session, editor } = this;
    const count = session.tree?.figures.levels ?? 3;
    const options = Array.from({ length: count }, (_, i) => ({
      value: String(i + 1),
      label: html`<span class="chip" data-level=${Math.min(i, 3)}></span>${treeWords.levels[i] ?? growWords.level(i)}`,
      title: growWords.drawHint(i),
    }));
    const shown = Math.min(doc.levelsShown, count);
    return html`<div class="part">${choice({
      name: 'levels',
      legend: growWords.draw,
      value: String(shown),
      options,
      onChoose: (value) => editor.actions.setLevels(Number(value) >= count ? ALL_LEVELS : Number(value)),
    })}
    ${toggle(
      'leaves',
      shown < count ? growWords.leavesWithAll : growWords.leaves,
      doc.showLeaves,
      (on) => editor.actions.setShowLeaves(on),
      { title: growWords.leavesHint, disabled: shown < count },
    )}</div>`;
  }
}

customElements.define('wg-grow', GrowPanel);
