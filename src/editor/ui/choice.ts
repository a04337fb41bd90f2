import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';

/** One of a few, as native radio buttons side by side. */
export interface Choice<T extends string> {
  readonly name: string;
  /** What the group asks. */
  readonly legend: string;
  /** Whether the legend is seen, or only spoken. */
  readonly quiet?: boolean;
  readonly value: T | null;
  readonly options: readonly { readonly value: T; readonly label: string | TemplateResult; readonly title?: string }[];
  readonly disabled?: boolean;
  readonly onChoose: (value: T) => void;
}

export function choice<T extends string>(c: Choice<T>): TemplateResult {
  return html`<fieldset class="choice ${c.name}" ?disabled=${c.disabled ?? false}>
    <legend class=${c.quiet ? 'spoken' : ''}>${c.legend}</legend>
    <div class="options">${c.options.map(
      (o) => html`<label title=${o.title ?? ''}><input type="radio" name=${c.name} value=${o.value}
        .checked=${live(o.value === c.value)} @change=${() => c.onChoose(o.value)}><span>${o.label}</span></label>`,
    )}</div>
  </fieldset>`;
}

/** On or off, as a native check box. */
export const toggle = (
  id: string,
  label: string | TemplateResult,
  checked: boolean,
  onChange: (on: boolean) => void,
  options: { readonly title?: string; readonly name?: string; readonly disabled?: boolean } = {},
): TemplateResult =>
  html`<label class="toggle" for=${id} title=${options.title ?? ''}><input type="checkbox" id=${id}
    aria-label=${options.name ?? (typeof label === 'string' ? label : '')} .checked=${live(checked)}
    ?disabled=${options.disabled ?? false} @change=${(e: Event) => onChange((e.target as HTMLInputElement).checked)}><span>${label}</span></label>`;
