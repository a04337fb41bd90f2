import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';

export interface SliderOptions {
  readonly label: string;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly value: number;
  /** The value as people read it. */
  readonly text: string;
  readonly onInput: (value: number) => void;
  /** A button beside the value that takes it back to what the forest has by itself. */
  readonly own?: { readonly label: string; readonly active: boolean; readonly onClick: () => void };
}

/** A labelled slider with its value in words. */
export const slider = ({ label, min, max, step, value, text, onInput, own }: SliderOptions): TemplateResult => html`
  <div class="field">
    <label>
      <span class="label">${label}</span>
      <input type="range" min=${min} max=${max} step=${step} .value=${live(String(value))} aria-valuetext=${text}
        @input=${(event: Event) => onInput((event.target as HTMLInputElement).valueAsNumber)}>
    </label>
    <output>${text}</output>
    ${own?.active ? html`<button class="quiet own" type="button" @click=${own.onClick} aria-label=${own.label} title=${own.label}>↺</button>` : nothing}
  </div>`;
