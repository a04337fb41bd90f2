import { html, type TemplateResult } from 'lit';
import { WAVE_NUMBERS } from '../../core/link/numbers.ts';
import { shownNumber } from '../../core/link/waves.ts';
import type { Wave } from '../../core/wind/wind.ts';
import type { Editor } from '../editor.ts';
import { toggle } from './choice.ts';
import { icon } from './icons.ts';
import { numberField } from './number-field.ts';

/** The numbers that a card offers; the phase follows from the others and is in the link alone. */
const offered = WAVE_NUMBERS.filter((n) => n.key !== 'phase');
const capital = (text: string): string => text[0]!.toUpperCase() + text.slice(1);

/** One of the four waves: a head that tells it at a glance, and its sliders. */
export function waveCard(editor: Editor, wave: Wave, index: number, original: Wave | undefined): TemplateResult {
  const name = `Wave ${index + 1}`;
  const fold = `wave-${index + 1}`;
  const number = (key: string): number => shownNumber(wave, offered.find((n) => n.key === key)!);
  return html`<section class="wave" ?data-off=${!wave.on} aria-label=${name}>
    <details ?open=${editor.preferences.folds[fold] ?? true}
      @toggle=${(e: Event) => editor.actions.setFold(fold, (e.currentTarget as HTMLDetailsElement).open)}>
      <summary>
        <span class="wave-name">${name}</span>
        <span class="wave-arrow" style="rotate: ${-number('direction')}deg">${icon('arrow')}</span>
        <span class="wave-sum">${number('amplitude').toFixed(3)}<span class="unit">m</span> <span class="wave-rhythm">every ${
          wave.speed > 0 ? (wave.wavelength / wave.speed).toFixed(1) : '∞'
        }<span class="unit">s</span></span></span>
      </summary>
      ${offered.map((n) =>
        numberField({
          id: `${fold}-${n.key}`,
          label: capital(n.label),
          name: `${name} ${n.label}`,
          unit: n.unit,
          value: shownNumber(wave, n),
          min: n.min,
          max: n.max,
          slider: n.slider,
          step: n.slider.step,
          decimals: n.decimals,
          turns: n.wraps ?? false,
          help: n.help,
          disabled: !wave.on,
          ...(original ? { reset: shownNumber(original, n) } : {}),
          onInput: (value) => editor.actions.setWaveNumber(index, n, value),
        }),
      )}
    </details>
    ${toggle(`${fold}-on`, '', wave.on, (on) => editor.actions.setWaveOn(index, on), { name: `${name} on` })}
  </section>`;
}
