import { type Camera, Matrix4, Vector3 } from 'three';
import type { Sun } from '../sun.ts';

const middle = new Vector3();
const ahead = new Vector3();
const turned = new Matrix4();
const inverse = new Matrix4();
const origin = new Vector3();

/** Metres before the map towards the light in which trees still cast into it, at most; a low sun's shadows come from afar. */
const BEFORE = 260;

/**
 * Fits the sun's shadow map to what a viewer has around and ahead: `reach` metres. It moves by whole texels, so that shadows stand still
 * while the viewer goes. `ground`: height of the ground under what is looked at, `relief`: metres that it may rise or fall within reach.
 */
export function followViewer(sun: Sun, camera: Camera, reach: number, ground: number, relief: number): void {
  middle.setFromMatrixPosition(camera.matrixWorld);
  camera.getWorldDirection(ahead);
  ahead.y = 0;
  if (ahead.lengthSq() > 1e-9) middle.addScaledVector(ahead.normalize(), 0.62 * reach);
  middle.y = ground;
  const { camera: light, mapSize } = sun.shadow;
  turned.identity().lookAt(sun.direction, origin, sun.up);
  inverse.copy(turned).invert();
  const texel = (2 * reach) / mapSize.x;
  middle.applyMatrix4(inverse);
  middle.x = Math.round(middle.x / texel) * texel;
  middle.y = Math.round(middle.y / texel) * texel;
  middle.applyMatrix4(turned);
  const away = BEFORE + relief;
  sun.target.position.copy(middle);
  sun.position.copy(middle).addScaledVector(sun.direction, away);
  sun.updateMatrixWorld();
  sun.target.updateMatrixWorld();
  const far = 2 * away;
  if (light.right !== reach || light.far !== far) {
    light.left = -reach;
    light.right = reach;
    light.top = reach;
    light.bottom = -reach;
    light.near = 1;
    light.far = far;
    light.updateProjectionMatrix();
  }
  sun.texel = texel;
  sun.shadow.normalBias = texel * 1.6;
  sun.shadow.bias = (-texel * 0.6) / far;
}
