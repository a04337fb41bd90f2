import type { Frame } from './photo-frame.ts';

/** Focal lengths that a lens may have, 35-mm equivalent, mm. */
export const SHORTEST = 15;
export const LONGEST = 200;

/** Half the diagonal of a picture on film, 36 by 24 mm: lenses are compared by it, whatever the picture's shape (CIPA DCG-001). */
const HALF_DIAGONAL = Math.hypot(36, 24) / 2;

/** Tangent of half the stage's vertical field of view. */
const HALF = Math.tan((15 * Math.PI) / 180);

/** The focal length in mm, 35-mm equivalent, at which the stage's own camera shows what is in the frame of a window of this height. */
export function ownFocalLength({ width, height }: Pick<Frame, 'width' | 'height'>, windowHeight: number): number {
  return (HALF_DIAGONAL * windowHeight) / (HALF * Math.hypot(width, height));
}
