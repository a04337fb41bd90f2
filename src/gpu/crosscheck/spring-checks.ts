import type { WebGLRenderer } from 'three';
import { PIECE_LAYERS, STATE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { bendVector } from '../../core/wind/bend.ts';
import { windStateAt } from '../../core/wind/fade.ts';
import { springDamping, springOmega } from '../../core/wind/spring-texels.ts';
import { STILL, type Wind } from '../../core/wind/wind.ts';
import { STEP } from '../step.ts';
import { type WindSource, windSource } from '../wind-source.ts';
import { gale, violentStorm } from './check-winds.ts';
import { dampingRatio, freeDecay } from './free-decay.ts';
import { passOf } from './pass-checks.ts';
import { stretching } from './pose-distance.ts';
import { Reference } from './reference.ts';
import { type Check, check } from './report.ts';

/** Where the bend of piece i along T is in a state, and after it the one along S. */
const bendOf = ({ pieces }: PackedTree, i: number): number => layerStart(pieces, STATE_TARGETS.Q) + 4 * i;

/** Steps of a free decay that are looked at: ten seconds. */
const DECAY = 600;

/** Swings that a piece must have made for its frequency to be measured. */
const SWINGS = 3;

/** A wind that has always blown and stops at time 0; no branch is shaken by another, so that each has a closed form. */
function stopping(): { wind: Wind; source: WindSource } {
  const wind: Wind = { ...gale, spring: { ...STILL.spring, damping: 0.06, inertia: 0 } };
  const calm: Wind = { ...wind, waves: [] };
  const fill: WindSource['fill'] = (time, out) => {
    windStateAt(time > 0 ? calm : wind, time, undefined, out);
  };
  return { wind, source: { ...windSource(wind), fill } };
}

/** Each branch of a tree, bent and let go, must swing and come to rest as its closed form says; measured from what the GPU holds. */
export function checkFreeDecay(renderer: WebGLRenderer, tree: PackedTree): Check[] {
  const { wind, source } = stopping();
  const { pass, dispose } = passOf(tree);
  const bends = Array.from({ length: tree.pieceCount }, () => new Float64Array(DECAY));
  for (let step = 0; step < DECAY; step++) {
    pass.update(renderer, step * STEP, source);
    const state = pass.readState(renderer) ?? new Float32Array();
    for (let i = 0; i < tree.pieceCount; i++) bends[i][step] = state[bendOf(tree, i)];
  }
  dispose();
  let measured = 0;
  let frequency = 0;
  let damping = 0;
  for (let i = 0; i < tree.pieceCount; i++) {
    const decay = freeDecay(bends[i], STEP);
    if (decay.swings < SWINGS) continue;
    measured++;
    const ratio = springDamping(tree, i, wind.spring);
    const omega = springOmega(tree, i, wind.spring) * Math.sqrt(1 - ratio * ratio);
    frequency = Math.max(frequency, Math.abs((2 * Math.PI) / decay.period / omega - 1));
    damping = Math.max(damping, Math.abs(dampingRatio(decay.decrement) / ratio - 1));
  }
  const samples = measured > tree.pieceCount / 2 ? measured : 0;
  return [
    check(
      'spring, free decay, frequency',
      samples,
      frequency,
      0.01,
      'part of the closed form’s, measured from the GPU’s state',
    ),
    check(
      'spring, free decay, damping',
      samples,
      damping,
      0.01,
      'part of the closed form’s, measured from the GPU’s state',
    ),
  ];
}

/** The most that a wind can push: all waves of it at their crests at once, to one side. */
const mostForce = (wind: Wind): number => wind.waves.reduce((sum, wave) => sum + wave.amplitude, 0) * wind.strength;

/**
 * The farthest that the spring of each piece can be driven: what never pushes it beyond `A` moves it by at most A coth(pi z/(2 sqrt(1 - z^2))),
 * z the damping, were it driven in time with it for ever. A is the wind's bend and the 1 that a parent's acceleration may add.
 */
function bounds(tree: PackedTree, wind: Wind): Float64Array {
  const tip = layerStart(tree.pieces, PIECE_LAYERS.TIP);
  const force = mostForce(wind);
  return Float64Array.from({ length: tree.pieceCount }, (_, i) => {
    const third = tree.pieces.data[tip + 4 * i + 3];
    const [bend] = bendVector(force, 0, third, wind.forceExponent, wind.lengthExponent);
    const z = springDamping(tree, i, wind.spring);
    return (bend + 1) / Math.tanh((Math.PI * z) / (2 * Math.sqrt(1 - z * z)));
  });
}

/** `steps` steps in a violent storm: nothing may grow beyond what the wind can do, nor become no number, nor stretch. */
export function checkBounded(renderer: WebGLRenderer, name: string, tree: PackedTree, steps: number): Check[] {
  const wind = violentStorm;
  const source = windSource(wind);
  const { pass, dispose } = passOf(tree);
  const bound = bounds(tree, wind);
  let beyond = 0;
  let moved = 0;
  const look = () => {
    const state = pass.readState(renderer) ?? new Float32Array();
    for (let i = 0; i < tree.pieceCount; i++) {
      const at = bendOf(tree, i);
      const bend = Math.hypot(state[at], state[at + 1]);
      moved = Math.max(moved, bend);
      if (!(bend <= bound[i])) beyond++;
    }
    if (!state.every(Number.isFinite)) beyond++;
  };
  // One jump: the pass runs it in slices, and shows its state after each.
  do {
    pass.update(renderer, steps * STEP, source);
    look();
  } while (pass.catchingUp !== null);
  const long = `${steps.toLocaleString('en')} steps at Beaufort 11`;
  const samples = moved > 0.1 ? steps : 0;
  const checks = [
    check(
      `spring, ${name}, ${long}`,
      samples,
      beyond,
      0,
      'bends beyond the bound of a driven spring, or no numbers: none',
    ),
    check(
      `spring, ${name}, ${long}, arc length`,
      samples,
      stretching(tree, pass.read(renderer)),
      1e-4,
      'of a piece’s length at rest',
    ),
  ];
  dispose();
  return checks;
}

/** The state after many steps against the reference's: how far rounding has led the two apart. */
export function checkLongRun(renderer: WebGLRenderer, name: string, tree: PackedTree, steps: number): Check {
  const source = windSource(violentStorm);
  const { pass, dispose } = passOf(tree);
  do pass.update(renderer, steps * STEP, source);
  while (pass.catchingUp !== null);
  const gpu = pass.readState(renderer) ?? new Float32Array();
  const twin = new Reference(tree, source).springs(steps * STEP);
  dispose();
  let error = gpu.length === twin.length ? 0 : Number.NaN;
  for (let i = 0; i < tree.pieceCount; i++) {
    const at = bendOf(tree, i);
    error = Math.max(error, Math.hypot(gpu[at] - twin[at], gpu[at + 1] - twin[at + 1]));
  }
  return check(
    `spring, ${name}, step ${steps.toLocaleString('en')}`,
    tree.pieceCount,
    error,
    1e-4,
    'bend against the reference’s',
  );
}
