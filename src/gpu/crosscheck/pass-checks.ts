import type { WebGLRenderer } from 'three';
import { PIECE_LAYERS, POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { createWindState } from '../../core/wind/fade.ts';
import { planeOf, poseTreePlainly } from '../../core/wind/pose-plainly.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { TreeTextures } from '../tree-textures.ts';
import { STEP, WindPass } from '../wind-pass.ts';
import { type WindSource, windSource } from '../wind-source.ts';
import { type Check, check } from './report.ts';

/** The pose after `step` steps by the reference; the lagged one by as many steps as the tree is deep, which is all it depends on. */
export function referencePose(tree: PackedTree, source: WindSource, step: number): Float32Array {
  const state = createWindState();
  const at = (n: number) => {
    source.fill(n * STEP, state);
    return state;
  };
  if (source.pose === 'exact') return poseTreePlainly(tree, at(step), 'exact');
  let pose = tree.restPose.data;
  for (let n = step - tree.depthStart.length + 2; n <= step; n++) pose = poseTreePlainly(tree, at(n), 'lagged', pose);
  return pose;
}

/** How far two poses of a tree are apart at worst. */
interface Distance {
  /** Control points, in parts of the tree's height or, where it is more, of ten times the piece's length. */
  readonly points: number;
  /** Orientation vectors, as the length of their difference. */
  readonly orientation: number;
}

/** Compares every piece of two poses; what is not a number is infinitely far. */
export function poseDistance(tree: PackedTree, a: Float32Array, b: Float32Array): Distance {
  const plane = planeOf(tree.restPose);
  const height = tree.bounds[5] - tree.bounds[2];
  let points = 0;
  let orientation = 0;
  for (let i = 0; i < tree.pieceCount; i++) {
    let turned = 0;
    for (let target = 0; target < 4; target++) {
      const at = target * plane + 4 * i;
      const away = Math.hypot(a[at] - b[at], a[at + 1] - b[at + 1], a[at + 2] - b[at + 2]);
      points = Math.max(points, Number.isNaN(away) ? Infinity : away / height);
      if (target < POSE_TARGETS.P3) turned = Math.hypot(turned, a[at + 3] - b[at + 3]);
    }
    orientation = Math.max(orientation, Number.isNaN(turned) ? Infinity : turned);
  }
  return { points, orientation };
}

/** How far the wind moves the tips at most, in parts of the tree's height: a still tree would agree with anything. */
function movement(tree: PackedTree, pose: Float32Array): number {
  const end = layerStart(tree.restPose, POSE_TARGETS.P3);
  let most = 0;
  for (let i = end; i < end + 4 * tree.pieceCount; i += 4) {
    const rest = tree.restPose.data;
    most = Math.max(most, Math.hypot(pose[i] - rest[i], pose[i + 1] - rest[i + 1], pose[i + 2] - rest[i + 2]));
  }
  return most / (tree.bounds[5] - tree.bounds[2]);
}

const STEPS = [1, 10, 600];

/** The wind pass against the reference after 1, 10 and 600 steps of one run, and a jump to the last against the run itself. */
export function checkPass(renderer: WebGLRenderer, name: string, tree: PackedTree, wind: Wind): Check[] {
  const source = windSource(wind);
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  const title = `wind pass, ${name}, ${wind.paper ? 'paper, ' : ''}${wind.pose}`;
  const checks: Check[] = [];
  let last = new Float32Array();
  let steps = 0;
  for (const step of STEPS) {
    while (steps < step) pass.update(renderer, ++steps * STEP, source);
    last = pass.read(renderer) as Float32Array<ArrayBuffer>;
    const reference = referencePose(tree, source, step);
    const { points, orientation } = poseDistance(tree, last, reference);
    const moved = movement(tree, reference);
    const samples = moved > 1e-3 ? tree.pieceCount : 0;
    const note = `of the tree’s height; the wind moves tips by ${moved.toFixed(3)} of it`;
    checks.push(check(`${title}, step ${step}`, 4 * samples, points, 2e-5, note));
    // Equation 8's projection, which the paper's forms use, enlarges rounding without bound where edges meet near a right angle.
    checks.push(check(`${title}, step ${step}, O`, samples, orientation, wind.paper ? 1e-3 : 1e-4, 'radians'));
  }
  const jumping = new WindPass(textures);
  jumping.update(renderer, steps * STEP, source);
  const { points } = poseDistance(tree, jumping.read(renderer), last);
  checks.push(check(`${title}, sought`, tree.pieceCount, points, 0, 'against the same step reached by playing: exact'));
  jumping.dispose();
  pass.dispose();
  textures.dispose();
  return checks;
}

/** Pieces whose rest pose the pass in still air does not give back, that is whose packing lost something. */
export function checkRest(renderer: WebGLRenderer, name: string, tree: PackedTree, still: Wind): Check[] {
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  pass.update(renderer, 0, windSource(still));
  const { points, orientation } = poseDistance(tree, pass.read(renderer), tree.restPose.data);
  pass.dispose();
  textures.dispose();
  const used = tree.pieces.layers > PIECE_LAYERS.TIP ? tree.pieceCount : 0;
  return [
    check(`rest pose, ${name}`, 4 * used, points, 2e-5, 'of the tree’s height; the pass in still air'),
    check(`rest pose, ${name}, O`, used, orientation, 1e-4, 'radians'),
  ];
}
