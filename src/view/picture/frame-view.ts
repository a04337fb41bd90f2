import { MathUtils } from 'three';
import { AZIMUTH, FOV } from '../stage.ts';
import type { Viewpoint } from './capture-stage.ts';
import type { PictureSize } from './picture.ts';

/** Part of a picture that its frame takes, from the middle to the edge. */
const FILLED = 0.94;

/** Degrees by which the eye is below the middle of the frame: one looks up to a tree. */
const LOW = 4;

/** Metres to the trunk from which a frame about it fills a picture of this shape. */
function distanceTo(frame: PictureSize, { width, height }: PictureSize): number {
  const half = Math.tan(MathUtils.degToRad(FOV / 2)) * FILLED;
  // What is in front of the trunk comes nearer and grows.
  return Math.max(frame.height / 2, (frame.width / 2) * (height / width)) / half + frame.width / 4;
}

/** Metres that such a picture shows from its lower to its upper edge, at the trunk; its middle is that of the frame. */
export const metresHigh = (frame: PictureSize, size: PictureSize): number =>
  2 * Math.tan(MathUtils.degToRad(FOV / 2)) * distanceTo(frame, size);

/** The view in which a frame about the trunk, in metres, fills a picture of this shape (pixels): the same frame, the same scale. */
export function frameView(frame: PictureSize, size: PictureSize): Viewpoint {
  const pose = {
    azimuth: MathUtils.radToDeg(AZIMUTH),
    elevation: -LOW,
    distance: distanceTo(frame, size),
    target: [0, frame.height / 2, 0],
  } as const;
  return { pose, high: 1, wide: 0 };
}
