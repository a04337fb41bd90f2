import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { toggle } from '../ui/choice.ts';
import { exportWords } from '../words/export.ts';
import type { Row } from './kinds.ts';

/** One option as its row of the table says it is: a box for a number, a switch, or a list; its help below. */
export function optionRow(
  row: Row,
  value: unknown,
  disabled: boolean,
  onChange: (value: unknown) => void,
): TemplateResult {
  const id = `export-${row.key}`;
  const help = html`<p class="option-help" id="${id}-help">${row.help}</p>`;
  if (row.kind === 'flag') {
    return html`<div class="option">${toggle(id, row.label, value === true, onChange, { disabled })}${help}</div>`;
  }
  if (row.kind === 'choice') {
    return html`<div class="option"><label for=${id}>${row.label}</label>
      <select id=${id} aria-describedby="${id}-help" .value=${live(String(value))} ?disabled=${disabled}
        @change=${(e: Event) => onChange((e.target as HTMLSelectElement).value)}>${row.choices.map(
          (choice) => html`<option value=${choice} ?selected=${choice === value}>${worded(choice)}</option>`,
        )}</select>${help}</div>`;
  }
  // Not `live`: what is being typed stays, however often the page is drawn meanwhile.
  const shown = String(value);
  const typed = (event: Event): void => {
    const box = event.target as HTMLInputElement;
    const number = row.integer ? Math.round(box.valueAsNumber) : box.valueAsNumber;
    // What cannot be used goes, and the last good number comes back.
    const good = number >= row.min && number <= row.max;
    box.value = good ? String(number) : shown;
    if (good) onChange(number);
  };
  return html`<div class="option"><label for=${id}>${row.label}</label>
    <span class="amount"><input type="number" id=${id} aria-describedby="${id}-help" min=${row.min} max=${row.max} step="any"
      .value=${shown} ?disabled=${disabled}
      @change=${typed}><span class="unit">${row.unit}</span></span>${help}</div>`;
}

/** A choice as people call it; sizes of textures are numbers and stay so. */
const worded = (choice: string): string => exportWords.choices[choice] ?? choice;
