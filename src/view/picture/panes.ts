import type { Compare, Insets } from './picture.ts';

/** The part of the picture in which one wind is shown, CSS pixels. */
export interface Pane {
  readonly which: 'A' | 'B';
  readonly left: number;
  readonly width: number;
  /** How far the middle of the view lies right of where it lies without a comparison. */
  readonly shift: number;
}

/** How a picture of `width` pixels is divided: one pane, or two side by side from edge to edge. */
export function panesOf(
  width: number,
  { left, right }: Insets,
  compare: Omit<Compare, 'wind'> | null,
): readonly Pane[] {
  if (!compare) return [{ which: 'A', left: 0, width, shift: 0 }];
  const clear = Math.max(2, width - left - right);
  const split = compare.layout === 'split';
  const middle = Math.round(split ? Math.min(1, Math.max(0, compare.at)) * width : left + clear / 2);
  const shift = split ? 0 : clear / 4;
  return [
    { which: 'A', left: 0, width: middle, shift: 0 - shift },
    { which: 'B', left: middle, width: width - middle, shift },
  ];
}
