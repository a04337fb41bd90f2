import type { WebGLRenderer } from 'three';
import { PIECE_LAYERS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { STILL, type Wind } from '../../core/wind/wind.ts';
import { STEP } from '../step.ts';
import { TreeTextures } from '../tree-textures.ts';
import { WindPass } from '../wind-pass.ts';
import { type WindSource, windSource } from '../wind-source.ts';
import { differing, movement, poseDistance, stretching } from './pose-distance.ts';
import { Reference } from './reference.ts';
import { type Check, check } from './report.ts';

/** A pass over a tree of its own, and what it takes to be rid of it. */
export function passOf(tree: PackedTree): { pass: WindPass; dispose(): void } {
  const textures = new TreeTextures(tree, true);
  const pass = new WindPass(textures);
  return {
    pass,
    dispose: () => {
      pass.dispose();
      textures.dispose();
    },
  };
}

/** Updates until the pose is of the time. */
export function seek(renderer: WebGLRenderer, pass: WindPass, time: number, source: WindSource): void {
  do pass.update(renderer, time, source);
  while (pass.catchingUp !== null);
}

/** The pose of a pass against the reference's at a time, in all three lines. */
function poseLines(
  title: string,
  tree: PackedTree,
  wind: Pick<Wind, 'paper'>,
  gpu: Float32Array,
  twin: Float32Array,
): Check[] {
  const { points, orientation, stir } = poseDistance(tree, gpu, twin);
  const moved = movement(tree, twin);
  const samples = moved > 1e-3 ? tree.pieceCount : 0;
  const note = `of the tree’s height; the wind moves tips by ${moved.toFixed(3)} of it`;
  return [
    check(title, 4 * samples, points, 2e-5, note),
    // Equation 8's projection, which the paper's forms use, enlarges rounding without bound where edges meet near a right angle.
    check(`${title}, O`, samples, orientation, wind.paper ? 1e-3 : 1e-4, 'radians'),
    check(`${title}, stir`, samples, stir, 1e-5, 'of how hard the wind shakes the leaves'),
  ];
}

const STEPS = [1, 10, 600];

/**
 * The wind pass against the reference after 1, 10 and 600 steps of one run, that no branch is stretched, and a jump to the last step, and
 * back and forth again, against the run itself.
 */
export function checkPass(renderer: WebGLRenderer, name: string, tree: PackedTree, wind: Wind): Check[] {
  const source = windSource(wind);
  const played = passOf(tree);
  const reference = new Reference(tree, source);
  const title = `wind pass, ${name}, ${wind.paper ? 'paper, ' : ''}${wind.model}, ${wind.pose}`;
  const checks: Check[] = [];
  let last = new Float32Array();
  let steps = 0;
  for (const step of STEPS) {
    while (steps < step) played.pass.update(renderer, ++steps * STEP, source);
    last = played.pass.read(renderer) as Float32Array<ArrayBuffer>;
    checks.push(...poseLines(`${title}, step ${step}`, tree, wind, last, reference.pose(step * STEP)));
  }
  if (!wind.paper) {
    checks.push(
      check(`${title}, arc length`, tree.pieceCount, stretching(tree, last), 1e-4, 'of a piece’s length at rest'),
    );
  }
  const state = played.pass.readState(renderer);
  const time = steps * STEP;
  const sought = passOf(tree);
  seek(renderer, sought.pass, time, source);
  const same = (pass: WindPass) =>
    differing(pass.read(renderer), last) + (wind.model === 'spring' ? differing(pass.readState(renderer), state) : 0);
  const note = 'numbers that differ from those of the same step reached by playing: none';
  checks.push(check(`${title}, sought`, tree.pieceCount, same(sought.pass), 0, note));
  for (const there of [0.3 * time, 0.9 * time, time]) seek(renderer, played.pass, there, source);
  checks.push(check(`${title}, sought back and forth`, tree.pieceCount, same(played.pass), 0, note));
  sought.dispose();
  played.dispose();
  return checks;
}

/** Two times while a wind blows or fades, one on a step and one between two. */
const TIMES = [60 * STEP, 80.4 * STEP];

/** The pass in a wind that asks for other shaders, against the reference. */
export function checkRareWind(renderer: WebGLRenderer, tree: PackedTree, name: string, source: WindSource): Check[] {
  const { pass, dispose } = passOf(tree);
  const reference = new Reference(tree, source);
  const paper = name.includes('paper');
  const checks = TIMES.flatMap((time, i) => {
    seek(renderer, pass, time, source);
    const title = `wind pass, ${name}, ${i === 0 ? 'at a step' : 'between two steps'}`;
    return poseLines(title, tree, { paper }, pass.read(renderer), reference.pose(time));
  });
  dispose();
  return checks;
}

/** Pieces whose rest pose the pass in still air does not give back, that is whose packing lost something. */
export function checkRest(renderer: WebGLRenderer, name: string, tree: PackedTree): Check[] {
  const { pass, dispose } = passOf(tree);
  pass.update(renderer, 0, windSource({ ...STILL, model: 'direct' }));
  const { points, orientation } = poseDistance(tree, pass.read(renderer), tree.restPose.data);
  dispose();
  const used = tree.pieces.layers > PIECE_LAYERS.TIP ? tree.pieceCount : 0;
  return [
    check(`rest pose, ${name}`, 4 * used, points, 2e-5, 'of the tree’s height; the pass in still air'),
    check(`rest pose, ${name}, O`, used, orientation, 1e-4, 'radians'),
  ];
}
