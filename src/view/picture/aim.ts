import { type PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';

const raycaster = new Raycaster();
const at = new Vector2();
const point = new Vector3();

/** A rectangle of the window that a camera's picture fills, CSS pixels. */
export interface Area {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** The ray through a point of the window; one object, overwritten by the next call. */
export function rayAt(x: number, y: number, area: Area, camera: PerspectiveCamera): Raycaster {
  at.set(((x - area.left) / area.width) * 2 - 1, 1 - ((y - area.top) / area.height) * 2);
  camera.updateMatrixWorld();
  raycaster.setFromCamera(at, camera);
  return raycaster;
}

/** Where the ground is at a point of the window, within `reach` metres of the eye; tree space (z up), null: the sky. */
export function groundAt(
  x: number,
  y: number,
  area: Area,
  camera: PerspectiveCamera,
  reach = 1000,
): { x: number; y: number } | null {
  const { origin, direction } = rayAt(x, y, area, camera).ray;
  const distance = -origin.y / direction.y;
  if (!(distance > 0) || distance > reach) return null;
  return { x: origin.x + direction.x * distance, y: -(origin.z + direction.z * distance) };
}

/** As `groundAt`, and where the sky is the ground at `reach` metres below it. */
export function groundTowards(
  x: number,
  y: number,
  area: Area,
  camera: PerspectiveCamera,
  reach: number,
): { x: number; y: number } {
  const found = groundAt(x, y, area, camera, reach);
  if (found) return found;
  const { origin, direction } = rayAt(x, y, area, camera).ray;
  const level = Math.hypot(direction.x, direction.z) || 1;
  return { x: origin.x + (direction.x / level) * reach, y: -(origin.z + (direction.z / level) * reach) };
}

/** Where a point in tree space (z up) is in the window; null: behind the eye. */
export function windowPoint(
  x: number,
  y: number,
  z: number,
  area: Area,
  camera: PerspectiveCamera,
): { x: number; y: number } | null {
  camera.updateMatrixWorld();
  point.set(x, z, -y).applyMatrix4(camera.matrixWorldInverse);
  if (point.z > -camera.near) return null;
  point.applyMatrix4(camera.projectionMatrix);
  return { x: area.left + ((point.x + 1) / 2) * area.width, y: area.top + ((1 - point.y) / 2) * area.height };
}

/** Metres that a pixel of a picture of `height` pixels is wide, a metre before the eye. */
export const metresAPixel = (camera: PerspectiveCamera, height: number): number =>
  2 / ((camera.projectionMatrix.elements[5] as number) * Math.max(1, height));
