import { html, svg, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { SHAPES, shapeRatio } from '../../../core/grow/stem-shape.ts';
import type { PruningParameters } from '../../../core/species/species.ts';
import { type Context, idOf, type State, spokenName } from './context.ts';

const STEPS = 12;

/** The outline of a crown shape in a box of 24 by 24, a stub of trunk below: ShapeRatio from the base of the crown to the top. */
export function shapeOutline(shape: number, pruning: PruningParameters): string {
  const side = Array.from({ length: STEPS + 1 }, (_, i) => {
    const height = i / STEPS;
    return [9 * shapeRatio(shape, 1 - height, pruning), 20 - 18 * height] as const;
  });
  const left = side.map(([r, y]) => `${(12 - r).toFixed(1)} ${y.toFixed(1)}`);
  const right = side.reverse().map(([r, y]) => `${(12 + r).toFixed(1)} ${y.toFixed(1)}`);
  return `M12 23V20L${[...left, ...right].join('L')}L12 20z`;
}

/** The crown shapes as small drawings to choose from, and the name of the chosen one. */
export function shapePicker(path: string, c: Context, state: State): TemplateResult {
  const chosen = state.value as number;
  return html`<span class="amounts wide shape-name" aria-hidden="true">${SHAPES[chosen]}</span>
    <span class="shapes" role="radiogroup" aria-label=${spokenName(path)}>${SHAPES.map(
      (
        name,
        id,
      ) => html`<label title=${name}><input type="radio" name=${idOf(path)} aria-label=${name} .checked=${live(id === chosen)}
        @change=${() => c.set(path, id)}><svg viewBox="0 0 24 24" aria-hidden="true">${svg`<path d=${shapeOutline(id, c.species.pruning)}></path>`}</svg></label>`,
    )}</span>`;
}
