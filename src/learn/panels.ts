import type { Margin } from './plane-map.ts';

/** A part of a stage: from and to, across and down, as parts of its width and height. */
export interface Part {
  readonly x?: readonly [number, number];
  readonly y?: readonly [number, number];
}

/** The margins that lay a view into a part of a stage, less `pad` pixels inside of it. */
export const marginsOf = (
  { width, height }: { readonly width: number; readonly height: number },
  { x = [0, 1], y = [0, 1] }: Part,
  { top = 8, right = 8, bottom = 8, left = 8 }: Partial<Margin> = {},
): Margin => ({
  left: x[0] * width + left,
  right: (1 - x[1]) * width + right,
  top: y[0] * height + top,
  bottom: (1 - y[1]) * height + bottom,
});
