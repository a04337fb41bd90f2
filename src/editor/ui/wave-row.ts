import { html, type TemplateResult } from 'lit';
import { WAVE_NUMBERS, type WaveNumber } from '../../core/link/numbers.ts';
import { shownNumber } from '../../core/link/waves.ts';
import { forceOfSpeed, speedOfForce } from '../../core/wind/speed.ts';
import type { Wave } from '../../core/wind/wind.ts';
import type { Editor } from '../editor.ts';
import { mixerWords } from '../words/wind-panel.ts';
import { toggle } from './choice.ts';
import { dial } from './dial.ts';
import { icon } from './icons.ts';
import { numberField } from './number-field.ts';

const AMPLITUDE = WAVE_NUMBERS.find((n) => n.key === 'amplitude')!;
const DIRECTION = WAVE_NUMBERS.find((n) => n.key === 'direction')!;
/** What a row shows only when it is opened. */
const FOLDED = WAVE_NUMBERS.filter((n) => n !== AMPLITUDE);
/** Digits of a speed or a length that are shown; the document keeps more, for loops. */
const SHOWN_DIGITS = 3;

const capital = (text: string): string => text[0]!.toUpperCase() + text.slice(1);

/** What a row of the mixer needs of it. */
export interface RowOf {
  readonly editor: Editor;
  readonly wave: Wave;
  readonly index: number;
  readonly count: number;
  readonly most: boolean;
  /** What a double click goes back to. */
  readonly original: Wave | undefined;
  /** It blows: it is on, and no other is alone. */
  readonly heard: boolean;
  readonly open: boolean;
  readonly onOpen: (open: boolean) => void;
  /** The grip is pulled, or moved with the arrow keys. */
  readonly onGrip: (event: PointerEvent) => void;
  readonly onMove: (to: number) => void;
}

/** One wave as a channel of an audio mixer: on, solo, its trace, direction, amplitude; the rest below when it is opened. */
export function waveRow(row: RowOf): TemplateResult {
  const { editor, wave, index, original, heard, open } = row;
  const { actions } = editor;
  const name = mixerWords.wave(index + 1);
  const id = `wave-${index + 1}`;
  const set = (n: WaveNumber) => (value: number) => actions.setWaveNumber(index, n, value);
  const field = (n: WaveNumber): TemplateResult =>
    numberField({
      id: `${id}-${n.key}`,
      label: capital(n.label),
      name: mixerWords.of(name, n.label),
      unit: n.unit,
      value: shownNumber(wave, n),
      min: n.min,
      max: n.max,
      slider: n.slider,
      step: n.slider.step,
      decimals: Math.min(SHOWN_DIGITS, n.decimals),
      turns: n.wraps ?? false,
      help: n.help,
      ...(original ? { reset: shownNumber(original, n) } : {}),
      ...(n === AMPLITUDE ? { also: { unit: 'm/s', decimals: 1, of: speedOfForce, back: forceOfSpeed } } : {}),
      onInput: set(n),
    });
  const onGripKey = (event: KeyboardEvent): void => {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (!by) return;
    event.preventDefault();
    row.onMove(index + by);
  };
  return html`<section class="wave" aria-label=${name} ?data-quiet=${!heard}>
    <div class="wave-head">
      <button type="button" class="grip" aria-label=${mixerWords.place(index + 1)} title=${mixerWords.placeTitle}
        @pointerdown=${row.onGrip} @keydown=${onGripKey}>${icon('grip')}</button>
      ${toggle(`${id}-on`, '', wave.on, (on) => actions.setWaveOn(index, on), { name: mixerWords.on(name), title: mixerWords.onTitle })}
      <button type="button" class="solo" aria-pressed=${wave.solo} aria-label=${mixerWords.solo(name)} title=${mixerWords.soloTitle}
        @click=${() => actions.setWaveSolo(index, !wave.solo)}>S</button>
      <button type="button" class="wave-open" aria-expanded=${open} aria-controls="${id}-more" aria-label=${mixerWords.all(name)}
        title=${mixerWords.all(name)} @click=${() => row.onOpen(!open)}><canvas class="trace" data-wave=${index}></canvas>
        <span class="wave-name" aria-hidden="true">${index + 1}</span>${icon(open ? 'up' : 'down')}</button>
      ${dial({ id: `${id}-dial`, name: mixerWords.dial(name), value: shownNumber(wave, DIRECTION), onInput: set(DIRECTION) })}
    </div>
    <div class="fader">${field(AMPLITUDE)}</div>
    <div class="wave-more" id="${id}-more" ?hidden=${!open}>${open ? html`${FOLDED.map(field)}${rowTools(row, name)}` : ''}</div>
  </section>`;
}

/** How often it comes, and what can be done with the whole row. */
function rowTools({ editor, wave, index, count, most, onMove }: RowOf, name: string): TemplateResult {
  const { actions } = editor;
  const period = wave.speed > 0 ? mixerWords.every(wave.wavelength / wave.speed) : mixerWords.still;
  const button = (
    label: string,
    picture: 'up' | 'down' | 'copy' | 'bin',
    act: () => void,
    off: boolean,
  ): TemplateResult => html`<button type="button" class="round" aria-label=${mixerWords.of(label, name.toLowerCase())} title=${label}
    ?disabled=${off} @click=${act}>${icon(picture)}</button>`;
  return html`<div class="wave-tools"><span class="soft">${period}</span><span class="buttons">
    ${button(mixerWords.up, 'up', () => onMove(index - 1), index === 0)}
    ${button(mixerWords.down, 'down', () => onMove(index + 1), index === count - 1)}
    ${button(mixerWords.copy, 'copy', () => actions.copyWave(index), most)}
    ${button(mixerWords.remove, 'bin', () => actions.removeWave(index), false)}</span></div>`;
}
