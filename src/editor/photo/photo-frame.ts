/** The shapes that a picture may have: that of the window, or width to height. */
export const ASPECTS = ['free', '1:1', '4:5', '16:9', '9:16'] as const;
export type Aspect = (typeof ASPECTS)[number];

/** A rectangle in pixels. */
export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Pixels that are left free around the frame. */
const EDGE = 16;

/** The largest frame of a shape in the middle of what is left of a window above its lowest `foot` pixels. */
export function frameIn(width: number, height: number, aspect: Aspect, foot: number): Frame {
  const most = { width: Math.max(1, width - 2 * EDGE), height: Math.max(1, height - EDGE - foot) };
  if (aspect === 'free') return { left: EDGE, top: EDGE, ...most };
  const [across, up] = aspect.split(':').map(Number) as [number, number];
  const unit = Math.min(most.width / across, most.height / up);
  const frame = { width: Math.round(unit * across), height: Math.round(unit * up) };
  return {
    left: Math.round((width - frame.width) / 2),
    top: Math.round(EDGE + (most.height - frame.height) / 2),
    ...frame,
  };
}

/** Pixels of the picture that a frame gives: those of the screen at least twice, and a longer side of `least`. */
export function pictureSize(
  { width, height }: Frame,
  pixelRatio: number,
  least = 1600,
): { width: number; height: number } {
  const factor = Math.max(2, pixelRatio, least / Math.max(width, height));
  return { width: Math.round(width * factor), height: Math.round(height * factor) };
}
