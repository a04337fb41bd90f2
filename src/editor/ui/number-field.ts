import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { fieldWords } from '../words/field.ts';
import { unlessTyping } from './unless-typing.ts';

/** A number as a slider and a box to type in, with one label and one unit. */
export interface NumberField {
  /** Unique in the page. */
  readonly id: string;
  /** What is seen before the slider. */
  readonly label: string;
  /** What screen readers say, where the label alone does not tell: `Wave 2 amplitude`. */
  readonly name?: string;
  readonly unit: string;
  readonly value: number;
  /** What may be typed. */
  readonly min: number;
  readonly max: number;
  /** What the slider reaches; `min`, `max` where absent. */
  readonly slider?: { readonly min: number; readonly max: number };
  /** Of the arrow keys; with Shift ten times as much. */
  readonly step: number;
  readonly decimals: number;
  /** A double click on the slider goes back to it. */
  readonly reset?: number;
  /** What the slider shows beside its value. */
  readonly marks?: Marks;
  readonly help?: string;
  /** The ends are the same: nothing is more or less. */
  readonly turns?: boolean;
  readonly disabled?: boolean;
  /** The same number in another unit, in a box of its own. */
  readonly also?: {
    readonly unit: string;
    readonly decimals: number;
    readonly of: (value: number) => number;
    readonly back: (shown: number) => number;
  };
  readonly onInput: (value: number) => void;
}

/** Marks on the track of a slider, in its own units. */
export interface Marks {
  /** A tick: the value that it had at first. */
  readonly tick?: number;
  /** A band this wide to both sides of the value: how much it varies. */
  readonly band?: number;
}

const spokenUnits: Record<string, string> = {
  m: 'metres',
  s: 'seconds',
  '°': 'degrees',
  'm/s': 'metres a second',
  '×': 'times',
  k: '',
  ζ: '',
  Hz: 'hertz',
  '1/s': 'a second',
  GPa: 'gigapascals',
  'kg/m³': 'kilograms a cubic metre',
  'kg/m²': 'kilograms a square metre',
};

/** `value` with as many digits as the step has, or as it needs, up to `most`. */
export function digits(value: number, step: number, most: number): string {
  const needed = (x: number): number => String(x).split('.')[1]?.length ?? 0;
  return value.toFixed(Math.min(most, Math.max(needed(step), needed(Number(value.toFixed(most))))));
}

/** A value as screen readers say it: '60 degrees'. */
export const spokenValue = (shown: string, unit: string): string => `${shown} ${spokenUnits[unit] ?? unit}`.trim();

/** A box to type a number in. */
export interface Amount {
  readonly id: string;
  readonly name: string;
  readonly unit: string;
  readonly shown: string;
  readonly min: number;
  readonly max: number;
  /** Of the up and down keys, with Shift ten times as much; absent: what the browser does. */
  readonly step?: number;
  readonly disabled?: boolean;
  /** Id of what explains it. */
  readonly describedBy?: string;
  /** What stands in an empty box, where it may be empty. */
  readonly placeholder?: string;
  readonly onTyped: (value: number) => void;
  /** The box was emptied, and may be. */
  readonly onEmptied?: () => void;
  /** What was typed cannot be used. */
  readonly onWrong?: () => void;
}

const clamp = (value: number, min: number, max: number): number => Math.min(max, Math.max(min, value));

/** A box to type a number in, and its unit; what cannot be used goes, and the last good number comes back. */
export function amount(a: Amount): TemplateResult {
  const { step } = a;
  const typed = (event: Event): void => {
    const box = event.target as HTMLInputElement;
    if (box.value !== '' && box.validity.valid) a.onTyped(box.valueAsNumber);
    else if (box.value === '' && !box.validity.badInput && a.onEmptied) a.onEmptied();
    else {
      box.value = a.shown;
      a.onWrong?.();
    }
  };
  const keys = (event: KeyboardEvent): void => {
    const towards = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!towards || step === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const box = event.target as HTMLInputElement;
    const from = box.value !== '' && box.validity.valid ? box.valueAsNumber : Number(a.shown || a.placeholder);
    a.onTyped(clamp(from + towards * step * (event.shiftKey ? 10 : 1), a.min, a.max));
  };
  const spoken = spokenUnits[a.unit] ?? a.unit;
  return html`<span class="amount"><input type="number" id=${a.id} aria-label=${fieldWords.number(a.name, spoken)}
      min=${a.min} max=${a.max} step="any" placeholder=${a.placeholder ?? nothing} .value=${unlessTyping(a.shown)} ?disabled=${a.disabled ?? false}
      aria-describedby=${a.describedBy ?? nothing} @change=${typed} @keydown=${keys}><span class="unit" aria-hidden="true">${a.unit}</span></span>`;
}

/** The slider of a number field. */
export type Slider = Pick<
  NumberField,
  'id' | 'name' | 'unit' | 'value' | 'step' | 'reset' | 'turns' | 'disabled' | 'marks' | 'onInput'
> & {
  readonly name: string;
  readonly min: number;
  readonly max: number;
  readonly shown: string;
  readonly describedBy?: string;
};

/** A slider: arrows a step, with Shift ten; a double click puts it back. */
export function slider(s: Slider): TemplateResult {
  const { value, min, max, step, marks, onInput } = s;
  const part = (x: number): string => ((100 * (clamp(x, min, max) - min)) / (max - min || 1)).toFixed(1);
  const coarse = (event: KeyboardEvent): void => {
    const towards = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (!event.shiftKey || !towards) return;
    event.preventDefault();
    onInput(clamp(value + towards * step * 10, min, max));
  };
  const band = Math.abs(marks?.band ?? 0);
  // What can be less than nothing is filled from nothing on.
  const from = min < 0 && max > 0 ? part(0) : '0.0';
  const [low, high] = [part(value), from].sort((a, b) => Number(a) - Number(b));
  const style = [
    `--filled: ${s.turns ? 0 : high}%`,
    low === '0.0' ? '' : `--from: ${low}%`,
    marks?.tick === undefined ? '' : `--tick: ${Number(part(marks.tick)) / 100}`,
    band === 0 ? '' : `--low: ${Number(part(value - band)) / 100}; --high: ${Number(part(value + band)) / 100}`,
  ];
  return html`<input type="range" id=${s.id} aria-label=${s.name} aria-valuetext=${spokenValue(s.shown, s.unit)}
      min=${min} max=${max} step=${step} .value=${live(String(value))} ?disabled=${s.disabled ?? false}
      aria-describedby=${s.describedBy ?? nothing} style=${style.filter(Boolean).join('; ')}
      ?data-tick=${marks?.tick !== undefined} ?data-band=${band > 0}
      @input=${(e: Event) => onInput((e.target as HTMLInputElement).valueAsNumber)}
      @keydown=${coarse} @dblclick=${() => s.reset !== undefined && onInput(s.reset)}>`;
}

/** Label, slider, number, unit: one row, or two where there is little room. */
export function numberField(field: NumberField): TemplateResult {
  const { id, label, name = label, unit, value, min, max, step, decimals, disabled = false, also, onInput } = field;
  const reach = field.slider ?? { min, max };
  const shown = digits(value, step, decimals);
  return html`<div class="field" ?data-disabled=${disabled} ?data-also=${also !== undefined}>
    <label for=${id} title=${field.help ?? ''}>${label}</label>
    ${slider({ ...field, name, min: reach.min, max: reach.max, shown })}
    ${amount({ id: `${id}-number`, name, unit, shown, min, max, step, disabled, onTyped: onInput })}
    ${
      also
        ? amount({
            id: `${id}-also`,
            name,
            unit: also.unit,
            shown: also.of(value).toFixed(also.decimals),
            min: also.of(min),
            max: also.of(max),
            disabled,
            onTyped: (typed) => onInput(also.back(typed)),
          })
        : ''
    }
  </div>`;
}
