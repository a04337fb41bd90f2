import { html, svg, type TemplateResult } from 'lit';
import { marginOutline } from '../../../core/look/margin-outline.ts';
import { treeWords } from '../../words/tree.ts';
import { type Context, idOf, type State } from './context.ts';
import { BOX, curveBox, type Mapping, mirrored } from './curve-box.ts';
import { curvePoint } from './curve-point.ts';

/** Half widths with which a free outline begins: an oval, widest below its middle. */
export const FIRST_MARGIN: readonly number[] = [0, 0.72, 1, 0.9, 0.56, 0];

const STEP = 0.01;

/** Pixels of half a blade, so that narrow ones can be taken hold of too. */
const NARROWEST = 44;
const WIDEST = BOX.width / 2 - 12;

const round = (value: number): number => Number(Math.min(1, Math.max(0, value)).toFixed(2));

/** A blade of the length 1 upright in the drawing; 1 is half its width. */
function bladeMapping(scaleX: number): Mapping {
  const long = BOX.height - BOX.foot - BOX.head;
  const half = Math.min(WIDEST, Math.max(NARROWEST, (long * scaleX) / 2));
  return {
    x: (part) => BOX.width / 2 + part * half,
    y: (part) => BOX.height - BOX.foot - part * long,
    back: (x, y) => ({ x: (x - BOX.width / 2) / half, z: (BOX.height - BOX.foot - y) / long }),
  };
}

/** The free outline of a blade as a curve: a point for each number of `foliage.margin`; a button where there is none. */
export function marginEditor(path: string, c: Context, state: State): TemplateResult {
  const margin = state.value as readonly number[] | null;
  const words = treeWords.margin;
  if (margin === null)
    return html`<button type="button" class="quiet draw-curve" @click=${() => c.set(path, FIRST_MARGIN)}>${words.draw}</button>`;
  const m = bladeMapping(c.species.leaves.scaleX);
  const last = margin.length - 1;
  const outline = marginOutline(margin).near.map(([x, z]) => [2 * x, z] as const);
  const set = (index: number, value: number): void => c.set(path, margin.with(index, round(value)));
  return html`${curveBox(
    words.picture,
    svg`<path class="tree-body" d=${mirrored(outline, m)}></path>
      <path class="tree-stems" d="M${BOX.width / 2} ${BOX.height}V${m.y(1)}"></path>
      <path class="curve-line" d=${mirrored(outline, m)}></path>
      ${margin.map((value, i) =>
        curvePoint({
          id: `${idOf(path)}-${i}`,
          name: words.point(i, margin.length),
          x: m.x(value),
          y: m.y(i / last),
          min: 0,
          max: 100,
          now: Math.round(100 * value),
          spoken: words.value(value),
          onDrag: (x, y) => set(i, m.back(x, y).x),
          onKey: (right, up) => set(i, value + STEP * (right + up)),
        }),
      )}`,
  )}<p class="note">${words.note}</p>
    <button type="button" class="quiet draw-curve" @click=${() => c.set(path, null)}>${words.back}</button>`;
}
