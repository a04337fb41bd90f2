import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';

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
};

/** `value` with as many digits as the step has, or as it needs, up to `most`. */
function digits(value: number, step: number, most: number): string {
  const needed = (x: number): number => String(x).split('.')[1]?.length ?? 0;
  return value.toFixed(Math.min(most, Math.max(needed(step), needed(Number(value.toFixed(most))))));
}

/** A box to type a number in, and its unit; what cannot be used goes, and the last good number comes back. */
function amount(
  id: string,
  name: string,
  unit: string,
  shown: string,
  range: { readonly min: number; readonly max: number; readonly disabled: boolean },
  onTyped: (value: number) => void,
): TemplateResult {
  const typed = (event: Event): void => {
    const box = event.target as HTMLInputElement;
    if (box.value !== '' && box.validity.valid) onTyped(box.valueAsNumber);
    else box.value = shown;
  };
  const spoken = spokenUnits[unit] ?? unit;
  return html`<span class="amount"><input type="number" id="${id}-number" aria-label="${name}, ${spoken || 'typed'}"
      min=${range.min} max=${range.max} step="any" .value=${live(shown)} ?disabled=${range.disabled}
      @change=${typed}><span class="unit" aria-hidden="true">${unit}</span></span>`;
}

/** Label, slider, number, unit: one row, or two where there is little room. */
export function numberField(field: NumberField): TemplateResult {
  const { id, label, name = label, unit, value, min, max, step, decimals, disabled = false, also, onInput } = field;
  const slider = field.slider ?? { min, max };
  const shown = digits(value, step, decimals);
  const spoken = `${shown} ${spokenUnits[unit] ?? unit}`.trim();
  const inside = Math.min(slider.max, Math.max(slider.min, value));
  const filled = field.turns ? 0 : (100 * (inside - slider.min)) / (slider.max - slider.min);

  const coarse = (event: KeyboardEvent): void => {
    const towards = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (!event.shiftKey || !towards) return;
    event.preventDefault();
    onInput(Math.min(slider.max, Math.max(slider.min, value + towards * step * 10)));
  };
  const range = { min, max, disabled };

  return html`<div class="field" ?data-disabled=${disabled} ?data-also=${also !== undefined}>
    <label for=${id} title=${field.help ?? ''}>${label}</label>
    <input type="range" id=${id} aria-label=${name} aria-valuetext=${spoken}
      min=${slider.min} max=${slider.max} step=${step} .value=${live(String(value))} ?disabled=${disabled}
      style="--filled: ${filled.toFixed(1)}%"
      @input=${(e: Event) => onInput((e.target as HTMLInputElement).valueAsNumber)}
      @keydown=${coarse} @dblclick=${() => field.reset !== undefined && onInput(field.reset)}>
    ${amount(id, name, unit, shown, range, onInput)}
    ${
      also
        ? amount(
            `${id}-also`,
            name,
            also.unit,
            also.of(value).toFixed(also.decimals),
            { min: also.of(min), max: also.of(max), disabled },
            (typed) => onInput(also.back(typed)),
          )
        : ''
    }
  </div>`;
}
