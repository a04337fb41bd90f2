import { html, type TemplateResult } from 'lit';
import type { Line } from './time-plot.ts';

/** A line as it is in the plot: its colour and its dashes. */
export const sample = ({ colour, dash }: Pick<Line, 'colour' | 'dash'>): TemplateResult =>
  html`<svg class="sample" viewBox="0 0 20 8" aria-hidden="true"><line x1="0" y1="4" x2="20" y2="4"
    style="stroke: var(--${colour}); stroke-dasharray: ${dash.join(' ') || 'none'}"></line></svg>`;

/** A plot with its heading and its key; what it is of is drawn into `.plot` by what knows the numbers. */
export const plotFigure = (
  id: string,
  [title, spoken]: readonly [title: string, spoken: string],
  unit: string,
  lines: readonly Line[],
  tall = false,
): TemplateResult => html`<figure class="plot-figure ${id}" ?data-tall=${tall}>
    <figcaption><h3>${title}</h3> <span class="unit" id="${id}-unit" .textContent=${unit}></span>
      <span class="key">${lines.map((line) => html`<span>${sample(line)}${line.label}</span>`)}</span>
      <output class="reading" id="${id}-reading" aria-hidden="true"></output></figcaption>
    <div class="plot" id="${id}-plot" role="img" aria-label=${spoken}></div>
  </figure>`;
