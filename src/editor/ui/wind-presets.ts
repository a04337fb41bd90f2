import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { OWN_WIND } from '../../core/link/link.ts';
import { sameValue } from '../../core/wind/same-before.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { windWords } from '../words/wind-panel.ts';
import { Part } from './panel.ts';

/** A wind without what the clock did to the phases of its waves, and without what passes once; of a record its name alone. */
const character = ({ waves, gusts: _, record, ...rest }: Wind) => ({
  ...rest,
  record: record?.name,
  waves: waves.map(({ phase: _, ...wave }) => wave),
});

/** The winds that ship as a strip of small pictures, and what the chosen one feels like. */
class WindPresets extends Part {
  private last = '';

  protected override render(): TemplateResult {
    const { actions } = this.editor;
    const { preset, wind } = actions.edited();
    const { winds } = this.session;
    const original = winds.find((w) => w.id === preset);
    const edited = original !== undefined && !sameValue(character(original.wind), character(wind));
    return html`<fieldset class="winds"><legend class="spoken">${windWords.begin}</legend>
      <div class="strip-of-winds">${winds.map(
        (w) => html`<label class="wind" title=${w.description}><input type="radio" name="preset" value=${w.id}
          .checked=${live(w.id === preset && !edited)} @change=${() => actions.setPreset(w.id)}>
          <img src=${w.thumbnail} alt="" width="72" height="48" loading="lazy"><span>${w.name}</span></label>`,
      )}</div></fieldset>
      <p class="feels">${
        original
          ? edited
            ? html`<strong>${original.name}</strong>${windWords.changed} <button type="button" class="text" @click=${() => actions.setPreset(preset)}>${windWords.putBack}</button>`
            : original.description
          : html`<strong>${wind.name}</strong>${preset === OWN_WIND ? windWords.own : '.'} ${wind.description}`
      }</p>`;
  }

  /** Brings the chosen wind into sight where it was chosen elsewhere. */
  protected override updated(): void {
    const { preset } = this.editor.actions.edited();
    if (preset === this.last) return;
    this.last = preset;
    const strip = this.querySelector<HTMLElement>('.strip-of-winds');
    const chosen = this.querySelector<HTMLElement>(`input[value="${CSS.escape(preset)}"]`)?.parentElement;
    if (!strip || !chosen) return;
    const at = chosen.offsetLeft - strip.offsetLeft;
    if (at < strip.scrollLeft || at + chosen.offsetWidth > strip.scrollLeft + strip.clientWidth)
      strip.scrollLeft = at - (strip.clientWidth - chosen.offsetWidth) / 2;
  }
}

customElements.define('wg-wind-presets', WindPresets);
