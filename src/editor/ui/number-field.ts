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
  readonly onInput: (value: number) => void;
}

const spokenUnits: Record<string, string> = {
  m: 'metres',
  s: 'seconds',
  '°': 'degrees',
  'm/s': 'metres a second',
  '×': 'times',
  k: '',
};

/** `value` with as many digits as the step has, or as it needs, up to `most`. */
function digits(value: number, step: number, most: number): string {
  const needed = (x: number): number => String(x).split('.')[1]?.length ?? 0;
  return value.toFixed(Math.min(most, Math.max(needed(step), needed(Number(value.toFixed(most))))));
}

/** Label, slider, number, unit: one row, or two where there is little room. */
export function numberField(field: NumberField): TemplateResult {
  const { id, label, name = label, unit, value, min, max, step, decimals, disabled = false, onInput } = field;
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
  const typed = (event: Event): void => {
    const box = event.target as HTMLInputElement;
    if (box.value !== '' && box.validity.valid) onInput(box.valueAsNumber);
    else box.value = shown; // what cannot be used goes; the last good number comes back
  };

  return html`<div class="field" ?data-disabled=${disabled}>
    <label for=${id} title=${field.help ?? ''}>${label}</label>
    <input type="range" id=${id} aria-label=${name} aria-valuetext=${spoken}
      min=${slider.min} max=${slider.max} step=${step} .value=${live(String(value))} ?disabled=${disabled}
      style="--filled: ${filled.toFixed(1)}%"
      @input=${(e: Event) => onInput((e.target as HTMLInputElement).valueAsNumber)}
      @keydown=${coarse} @dblclick=${() => field.reset !== undefined && onInput(field.reset)}>
    <span class="amount"><input type="number" id="${id}-number" aria-label="${name}${unit && unit !== 'k' ? `, ${spokenUnits[unit] ?? unit}` : ', typed'}"
      min=${min} max=${max} step="any" .value=${live(shown)} ?disabled=${disabled}
      @change=${typed}><span class="unit" aria-hidden="true">${unit}</span></span>
  </div>`;
}
