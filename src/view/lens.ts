import { MathUtils, type PerspectiveCamera, type Vector3 } from 'three';
import type { Stage } from './stage.ts';

/** How another lens shows what the camera looks at. */
export interface Lens {
  /** Its focal length as a multiple of that of the camera's own, > 0. */
  readonly zoom: number;
  /** The camera goes nearer or farther, so that what it looks at keeps its size. */
  readonly keepsSize: boolean;
}

/**
 * Steps with `camera` so that `target` is `zoom` times as far away. An eye below its target stays at its height, or a step back would
 * take it underground.
 */
function step(camera: PerspectiveCamera, target: Vector3, zoom: number): void {
  const { y } = camera.position;
  camera.position.sub(target).multiplyScalar(zoom).add(target);
  if (y < target.y) camera.position.y = y;
  camera.lookAt(target);
  camera.near *= Math.min(1, zoom);
  camera.far *= Math.max(1, zoom);
}

/** Puts a lens on the stage's camera; what it returns takes it off. The orbit knows nothing of it, and so does the document. */
export function putOn({ camera, controls }: Pick<Stage, 'camera' | 'controls'>, { zoom, keepsSize }: Lens): () => void {
  const { fov, near, far } = camera;
  const [position, quaternion] = [camera.position.clone(), camera.quaternion.clone()];
  camera.fov = 2 * MathUtils.radToDeg(Math.atan(Math.tan(MathUtils.degToRad(fov / 2)) / zoom));
  if (keepsSize) step(camera, controls.target, zoom);
  camera.updateProjectionMatrix();
  return () => {
    Object.assign(camera, { fov, near, far });
    camera.position.copy(position);
    camera.quaternion.copy(quaternion);
    camera.updateProjectionMatrix();
  };
}
