import { type Box3, type PerspectiveCamera, Vector3 } from 'three';

/** A part of a picture of the same shape: its upper left corner and its size, in parts of the whole. */
export interface Crop {
  readonly x: number;
  readonly y: number;
  readonly part: number;
}

export const WHOLE: Crop = { x: 0, y: 0, part: 1 };

/** Air around what is shown, as a part of the crop. */
const AIR = 0.07;

const corner = new Vector3();

/** Points around the upright round that a box holds: a crown has no corners, and those of its box stand out beside it. */
const AROUND = 16;

/** The smallest part of what a camera sees that holds the upright round in a box, with some air around it. */
export function closeUp(box: Box3, camera: PerspectiveCamera): Crop {
  camera.updateMatrixWorld();
  let [left, top, right, bottom] = [1, 1, 0, 0];
  const size = box.getSize(new Vector3()).multiplyScalar(0.5);
  for (let i = 0; i < 2 * AROUND; i++) {
    const angle = (i * 2 * Math.PI) / AROUND;
    box.getCenter(corner).x += size.x * Math.cos(angle);
    corner.y += i < AROUND ? size.y : -size.y;
    corner.z += size.z * Math.sin(angle);
    corner.project(camera);
    left = Math.min(left, (corner.x + 1) / 2);
    right = Math.max(right, (corner.x + 1) / 2);
    top = Math.min(top, (1 - corner.y) / 2);
    bottom = Math.max(bottom, (1 - corner.y) / 2);
  }
  const part = Math.min(1, Math.max(right - left, bottom - top) / (1 - 2 * AIR));
  const within = (middle: number): number => Math.min(1 - part, Math.max(0, middle - part / 2));
  return { x: within((left + right) / 2), y: within((top + bottom) / 2), part };
}
