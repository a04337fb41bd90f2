import { html, svg, type TemplateResult } from 'lit';
import type { Silhouette } from './silhouette.ts';

/** Pixels of a drawing at its own size; it is as wide as the panel. */
export const BOX = { width: 232, height: 216, foot: 8, head: 12 } as const;

/** From parts of the tree's size to the drawing and back. */
export interface Mapping {
  x(part: number): number;
  y(part: number): number;
  /** Parts, from a point of the drawing. */
  back(x: number, y: number): { readonly x: number; readonly z: number };
}

/** A mapping that shows heights up to `top` and `half` to both sides, alike in both directions. */
export function mapping(top: number, half: number): Mapping {
  const high = BOX.height - BOX.foot - BOX.head;
  const pixels = Math.min(high / Math.max(top, 1e-3), BOX.width / 2 / Math.max(half, 1e-3));
  return {
    x: (part) => BOX.width / 2 + part * pixels,
    y: (part) => BOX.height - BOX.foot - part * pixels,
    back: (x, y) => ({ x: (x - BOX.width / 2) / pixels, z: (BOX.height - BOX.foot - y) / pixels }),
  };
}

const px = (x: number): string => x.toFixed(1);

/** A path through points of the tree, both sides of the axis; radius and height, in parts. */
export function mirrored(points: readonly (readonly [radius: number, height: number])[], m: Mapping): string {
  const right = points.map(([r, z]) => `${px(m.x(r))} ${px(m.y(z))}`);
  const left = points.map(([r, z]) => `${px(m.x(-r))} ${px(m.y(z))}`);
  return `M${right.join('L')}L${left.reverse().join('L')}z`;
}

/** The tree as it stands, in grey. */
export function drawnTree(s: Silhouette, m: Mapping): TemplateResult {
  const { lines, reach, top } = s;
  const bin = top / reach.length;
  const body = [...reach].map((r, i) => [r, (i + 0.5) * bin] as const).filter(([r]) => r > 0);
  let d = '';
  for (let i = 0; i < lines.length; i += 4)
    d += `M${px(m.x(lines[i]!))} ${px(m.y(lines[i + 1]!))}L${px(m.x(lines[i + 2]!))} ${px(m.y(lines[i + 3]!))}`;
  return svg`<path class="tree-body" d=${body.length > 1 ? mirrored(body, m) : ''}></path>
    <path class="tree-stems" d=${d}></path>
    <path class="ground" d="M0 ${px(m.y(0))}H${BOX.width}"></path>`;
}

/** A drawing with what is drawn in it. */
export const curveBox = (label: string, content: unknown): TemplateResult =>
  html`<svg class="curve" viewBox="0 0 ${BOX.width} ${BOX.height}" role="group" aria-label=${label}>${content}</svg>`;
