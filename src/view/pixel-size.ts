import { Box3, type Camera, type Matrix4, Vector3 } from 'three';

const eye = new Vector3();
const world = new Box3();

/**
 * Pixels that a metre takes on a screen of `height` pixels at the point of a box that is nearest to the camera.
 *
 * Inside the box the distance is a tenth of its size: what is right at the eye is a small part of the whole.
 */
export function pixelsPerMetre(camera: Camera, matrixWorld: Matrix4, box: Box3, height: number): number {
  const { elements } = camera.projectionMatrix;
  const scale = (elements[5] as number) * height * 0.5;
  if (elements[15] === 1) return scale; // orthographic: no distance in it
  eye.setFromMatrixPosition(camera.matrixWorld);
  world.copy(box).applyMatrix4(matrixWorld);
  const size = world.max.distanceTo(world.min);
  return scale / Math.max(world.distanceToPoint(eye), 0.1 * size, 1e-3);
}
