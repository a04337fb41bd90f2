import { html, nothing, svg, type TemplateResult } from 'lit';
import { crownCurve } from '../../../core/grow/crown-curve.ts';
import { shapeRatio } from '../../../core/grow/stem-shape.ts';
import type { Species } from '../../../core/species/species.ts';
import { treeWords } from '../../words/tree.ts';
import { type Context, idOf, type State } from './context.ts';
import { curveBox, drawnTree, mapping, mirrored } from './curve-box.ts';
import { curvePoint } from './curve-point.ts';

/** Points of a curve that begins as one of the crown shapes. */
const POINTS = 5;
const STEPS = 32;
const STEP = 0.01;

const round = (value: number): number => Number(Math.min(1, Math.max(0, value)).toFixed(2));

/** The lengths of the main branches that the species' crown shape gives, from the base of the crown to its top. */
export const curveOfShape = ({ tree, pruning }: Species): readonly number[] =>
  Array.from({ length: POINTS }, (_, i) => round(shapeRatio(tree.shape, 1 - i / (POINTS - 1), pruning)));

/** The crown as a curve over the tree: a point for each number of `tree.crown`; a button where there is none. */
export function crownEditor(path: string, c: Context, state: State): TemplateResult {
  const curve = state.value as readonly number[] | null;
  const words = treeWords.crown;
  if (curve === null)
    return html`<button type="button" class="quiet draw-curve" @click=${() => c.set(path, curveOfShape(c.species))}>${words.draw}</button>`;
  return html`${crownCurveBox(path, c, curve)}<p class="note">${words.note}</p>
    ${
      // A curve that the species itself has goes back with its own reset.
      state.first === null
        ? html`<button type="button" class="quiet draw-curve" @click=${() => c.editor.actions.resetParameter(path)}>${words.back}</button>`
        : nothing
    }`;
}

function crownCurveBox(path: string, c: Context, curve: readonly number[]): TemplateResult {
  const { species } = c;
  const tree = c.silhouette();
  // A limb of the full length, from the axis outwards.
  const full = Math.max(species.levels[Math.min(1, species.levels.length - 1)]!.length, 0.05);
  const m = mapping(Math.max(1, tree?.top ?? 1), c.stretch('crown', Math.max(full, tree?.radius ?? 0) * 1.1));
  const { baseSize } = species.tree;
  const height = (part: number): number => baseSize + part * (1 - baseSize);
  const outline = Array.from({ length: STEPS + 1 }, (_, i) => {
    const part = i / STEPS;
    return [full * crownCurve(curve, part), height(part)] as const;
  });
  const last = curve.length - 1;
  const set = (index: number, value: number): void => c.set(path, curve.with(index, round(value)));
  return curveBox(
    treeWords.crown.picture,
    svg`${tree ? drawnTree(tree, m) : nothing}
      <path class="curve-line" d=${mirrored(outline, m)}></path>
      ${curve.map((value, i) =>
        curvePoint({
          id: `${idOf(path)}-${i}`,
          name: treeWords.crown.point(i, curve.length),
          x: m.x(full * value),
          y: m.y(height(i / last)),
          min: 0,
          max: 100,
          now: Math.round(100 * value),
          spoken: treeWords.crown.value(value),
          onDrag: (x, y) => set(i, m.back(x, y).x / full),
          onKey: (right, up) => set(i, value + STEP * (right + up)),
        }),
      )}`,
  );
}
