import { html, type TemplateResult } from 'lit';
import { LINK_NUMBERS } from '../../core/link/numbers.ts';
import { roundWind } from '../../core/link/waves.ts';
import { presets } from '../../core/wind/presets.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { choice, toggle } from './choice.ts';
import { fold } from './fold.ts';
import { numberField } from './number-field.ts';
import { Part } from './panel.ts';
import { waveCard } from './wave-card.ts';

/** The waves of a wind without what the clock did to their phases. */
const character = (wind: Wind): string =>
  JSON.stringify([wind.strength, wind.waves.map(({ phase: _, ...rest }) => rest)]);

/** `fresh-breeze` as `Fresh breeze`. */
const presetName = (id: string): string => (id[0]!.toUpperCase() + id.slice(1)).replaceAll('-', ' ');

/** What blows: on or off, a preset, four waves. */
class WindPanel extends Part {
  protected override render(): TemplateResult {
    const { doc, editor } = this;
    const original = roundWind(presets[doc.preset] ?? doc.wind);
    const edited = character(original) !== character(doc.wind);
    return html`
      ${toggle('blowing', html`Wind`, doc.blowing, (on) => editor.actions.setBlowing(on), { name: 'Wind', title: 'Wind on or off (B)' })}
      ${choice({
        name: 'preset',
        legend: 'Begin with',
        value: edited ? null : doc.preset,
        options: Object.keys(presets).map((value) => ({ value, label: presetName(value) })),
        onChoose: (id) => editor.actions.setPreset(id),
      })}
      ${edited ? html`<p class="edited">${presetName(doc.preset)}, edited. <button type="button" class="text" @click=${() => editor.actions.setPreset(doc.preset)}>Put back</button></p>` : ''}
      ${numberField({
        ...LINK_NUMBERS.strength,
        id: 'strength',
        label: 'Strength',
        name: 'Wind strength',
        value: doc.wind.strength,
        step: 0.01,
        reset: original.strength,
        help: 'A factor on all four waves',
        onInput: (value) => editor.actions.setStrength(value),
      })}
      <div class="waves">${doc.wind.waves.map((wave, i) => waveCard(editor, wave, i, original.waves[i]))}</div>
      ${fold(editor, 'advanced', 'Advanced', this.advanced(original))}`;
  }

  private advanced(original: Wind): TemplateResult {
    const { doc, editor } = this;
    return html`
      ${choice({
        name: 'pose',
        legend: 'Branches follow their parents',
        value: doc.wind.pose,
        options: [
          { value: 'exact', label: 'At once', title: 'Depth by depth: no lag' },
          {
            value: 'lagged',
            label: 'One step late',
            title: 'All at once, parents from the last step, as in the paper',
          },
        ],
        onChoose: (pose) => editor.actions.setPose(pose),
      })}
      ${toggle('paper', 'As the paper prints it', doc.wind.paper, (on) => editor.actions.setPaper(on), {
        title: 'Waves that travel upwind, lengths that change, projected frames (Skjermo 2007)',
      })}
      ${numberField({
        ...LINK_NUMBERS.p,
        id: 'exponent-force',
        label: 'Force to the power',
        value: doc.wind.forceExponent,
        step: 0.05,
        reset: original.forceExponent,
        help: 'Exponent p of the force (equation 16 prints 1.8)',
        onInput: (value) => editor.actions.setForceExponent(value),
      })}
      ${numberField({
        ...LINK_NUMBERS.m,
        id: 'exponent-length',
        label: 'Length to the power',
        value: doc.wind.lengthExponent,
        step: 0.05,
        reset: original.lengthExponent,
        help: 'Exponent m of the length that divides the force (the paper: 2)',
        onInput: (value) => editor.actions.setLengthExponent(value),
      })}`;
  }
}

customElements.define('wg-wind', WindPanel);
