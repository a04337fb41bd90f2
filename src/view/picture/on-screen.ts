import { type Object3D, type PerspectiveCamera, Vector3 } from 'three';
import { bezierPoint, type Cubic } from '../../core/math/bezier.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import { POSE_TARGETS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { OnScreen } from './picture.ts';

/** Points along a piece. */
const POINTS = 9;

/** Tips (P3) of all pieces of a pose (laid out as `restPose`), 3 a piece, tree space. */
export function tipsOf({ pieceCount, restPose }: PackedTree, pose: Float32Array): Float32Array {
  const first = POSE_TARGETS.P3 * restPose.width * restPose.height * TEXEL;
  const tips = new Float32Array(3 * pieceCount);
  for (let i = 0; i < pieceCount; i++) tips.set(pose.subarray(first + TEXEL * i, first + TEXEL * i + 3), 3 * i);
  return tips;
}

/** Where the pieces of a pose (laid out as `restPose`) are on the screen, and the horizon, seen by `camera` in `canvas`. */
export function onScreen(
  packed: PackedTree,
  pose: Float32Array,
  tree: Object3D,
  camera: PerspectiveCamera,
  canvas: HTMLCanvasElement,
): Pick<OnScreen, 'branches' | 'horizon'> {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const at = new Vector3();
  const project = (): [number, number] => {
    at.project(camera);
    return [left + ((at.x + 1) / 2) * width, top + ((1 - at.y) / 2) * height];
  };
  const plane = packed.restPose.width * packed.restPose.height * TEXEL;
  const control = (i: number, target: number): Vec3 => {
    const k = target * plane + i * TEXEL;
    return [pose[k]!, pose[k + 1]!, pose[k + 2]!];
  };
  const branches: number[] = [];
  for (let i = 0; i < packed.pieceCount; i++) {
    const curve: Cubic = { p0: control(i, 0), p1: control(i, 1), p2: control(i, 2), p3: control(i, 3) };
    for (let k = 0; k < POINTS; k++) {
      const [x, y, z] = bezierPoint(curve, k / (POINTS - 1));
      at.set(x, z, -y).applyMatrix4(tree.matrixWorld); // tree space is z-up, the picture y-up
      branches.push(...project());
    }
  }
  camera.getWorldDirection(at).setY(0).normalize().multiplyScalar(1e5).add(camera.position);
  return { branches, horizon: project()[1] };
}
