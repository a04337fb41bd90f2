import { matrixFromQuaternion, type Quaternion } from '../math/quaternion.ts';
import type { Mat3, Vec3 } from '../math/vec3.ts';
import { SPRING_LAYERS, STATE_TARGETS, SWAY_LAYERS } from '../pack/layout.ts';
import type { TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { type BendModel, directPush, framePush, mixPush, type Push } from './bend.ts';
import { type ForceUniforms, windForce } from './force.ts';
import type { RestPiece } from './pose.ts';
import { type Spring, springBend, springStir } from './spring.ts';
import { swayClock, swayStir, swaySwing, swayUniform } from './sway.ts';
import type { BendModelName, SwaySettings } from './wind.ts';

/** The wind at one time and how it bends: what `WindFader.at` gives. */
export interface WindToPose extends ForceUniforms, BendModel {
  /** Seconds. */
  time: number;
  model: BendModelName;
  /** The model that fades out, or null; `modelFade` is the weight of `model`, 0..1. */
  from: BendModelName | null;
  modelFade: number;
  sway: SwaySettings;
  loudness: number;
}

/** What the models `spring` and `sway` need beside the pieces. */
export interface Bends {
  /**
   * Layers of SPRING_LAYERS, and the state of the springs at the time of the pose, laid out as STATE_TARGETS. Without it a spring is
   * bent as it comes to rest in this wind, that is as `direct` bends it.
   */
  springs?: { texels: TexelArray; state: Float32Array };
  /** Layers of SWAY_LAYERS; what has none does not sway. */
  sway?: TexelArray;
}

/** Does the pose of this wind depend on `model`? */
export const uses = ({ model, from }: Pick<WindToPose, 'model' | 'from'>, name: BendModelName): boolean =>
  model === name || from === name;

/** A push, and how hard it shakes the leaves, metres of force. */
export interface Stirred {
  push: Push;
  stir: number;
}

const texelOf = (data: Float32Array, at: number): [number, number, number, number] => [
  data[at],
  data[at + 1],
  data[at + 2],
  data[at + 3],
];

/** The state of piece i in an array laid out as STATE_TARGETS, `plane` floats a target. */
export function springOf(state: Float32Array, plane: number, i: number): Spring {
  const q = texelOf(state, STATE_TARGETS.Q * plane + 4 * i);
  const base = texelOf(state, STATE_TARGETS.BASE * plane + 4 * i);
  const end = texelOf(state, STATE_TARGETS.END * plane + 4 * i);
  return {
    q: [q[0], q[1]],
    velocity: [q[2], q[3]],
    base: [base[0], base[1], base[2]],
    force: base[3],
    end: [end[0], end[1], end[2]],
    along: end[3],
  };
}

/** Writes a state as STATE_TARGETS says. */
export function writeSpring(state: Float32Array, plane: number, i: number, spring: Spring): void {
  state.set([...spring.q, ...spring.velocity], STATE_TARGETS.Q * plane + 4 * i);
  state.set([...spring.base, spring.force], STATE_TARGETS.BASE * plane + 4 * i);
  state.set([...spring.end, spring.along], STATE_TARGETS.END * plane + 4 * i);
}

/** The frame at rest of piece i: columns L, T and S. */
export const springFrame = (texels: TexelArray, i: number): Mat3 =>
  matrixFromQuaternion(texelOf(texels.data, layerStart(texels, SPRING_LAYERS.FRAME) + 4 * i) as Quaternion);

/** What one model does to piece i, whose stem feels the wind at `tip` and whose base frame now is `frame`. */
function modelPush(
  model: BendModelName,
  i: number,
  rest: RestPiece,
  tip: Vec3,
  frame: Mat3,
  wind: WindToPose,
  { springs, sway }: Bends,
): Stirred {
  if (model === 'sway' && sway) {
    const gain = texelOf(sway.data, layerStart(sway, SWAY_LAYERS.GAIN) + 4 * i);
    const offset = texelOf(sway.data, layerStart(sway, SWAY_LAYERS.OFFSET) + 4 * i);
    const parts = swayUniform(wind.sway, wind.loudness);
    const swing = swaySwing(gain, offset, parts, swayClock(wind.time));
    const push = framePush(frame, [0, swing[0], swing[1]], [gain[0], gain[1]], wind.softness);
    return { push, stir: swayStir(swing, parts) };
  }
  if (model === 'spring' && springs) {
    const spring = springOf(springs.state, layerStart(springs.texels, 1), i);
    const push = framePush(springFrame(springs.texels, i), springBend(spring), rest.weights, wind.softness);
    return { push, stir: springStir(spring, rest.third) };
  }
  const still = model === 'sway';
  const force = still ? ([0, 0] as [number, number]) : windForce(wind, tip[0], tip[1], tip[2]);
  const stir = Math.sqrt(force[0] * force[0] + force[1] * force[1]);
  return { push: directPush(force, rest.third, rest.weights, wind), stir };
}

/** What the wind does to piece i by its bend model, or between two while one fades into the other. */
export function piecePush(
  i: number,
  rest: RestPiece,
  tip: Vec3,
  frame: Mat3,
  wind: WindToPose,
  bends: Bends = {},
): Stirred {
  const to = modelPush(wind.model, i, rest, tip, frame, wind, bends);
  if (wind.from === null) return to;
  const from = modelPush(wind.from, i, rest, tip, frame, wind, bends);
  const f = wind.modelFade;
  return { push: mixPush(from.push, to.push, f), stir: from.stir * (1 - f) + to.stir * f };
}
