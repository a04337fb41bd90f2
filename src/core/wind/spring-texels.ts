import { writeColumns } from '../math/columns.ts';
import { across } from '../math/frames.ts';
import { writeQuaternion } from '../math/quaternion.ts';
import { unit, type Vec3 } from '../math/vec3.ts';
import { MECHANICS, MECHANICS_SIZE, POSE_TARGETS, SPRING_LAYERS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart, texelArray } from '../pack/texel-array.ts';
import { SPRING_RATE, springTransition } from './spring.ts';
import { SPRING_LEVELS, type SpringLevel, type SpringSettings } from './wind.ts';

/** What a tree must have for its stems to be springs. */
export type SpringTree = Pick<PackedTree, 'pieceCount' | 'restPose' | 'mechanics'>;

/** Least and largest angular frequency, rad/s, and damping ratio: what a file says is kept within them. */
const OMEGA = [1e-3, 1e4] as const;
const DAMPING = [1e-6, 1e3] as const;

const within = (x: number, [least, most]: readonly [number, number]): number => Math.min(Math.max(x, least), most);

const levelOf = ({ mechanics }: Pick<SpringTree, 'mechanics'>, piece: number, { levels }: SpringSettings) =>
  levels[Math.min(mechanics[MECHANICS_SIZE * piece + MECHANICS.LEVEL], SPRING_LEVELS - 1)] as SpringLevel | undefined;

/**
 * Natural angular frequency of a piece's stem in a wind, rad/s: as grown, times the factor of the settings and the root of the tree's
 * `stiffness`; or what the settings say of its level, just so.
 */
export function springOmega(
  tree: Pick<SpringTree, 'mechanics'>,
  piece: number,
  settings: SpringSettings,
  stiffness = 1,
): number {
  const given = levelOf(tree, piece, settings)?.frequency;
  const grown = tree.mechanics[MECHANICS_SIZE * piece + MECHANICS.OMEGA] * settings.frequency * Math.sqrt(stiffness);
  return within(given ? 2 * Math.PI * given : grown, OMEGA);
}

/** Damping ratio of a piece's stem in a wind: that of the settings, times the tree's own; or what the settings say of its level, just so. */
export function springDamping(tree: Pick<SpringTree, 'mechanics'>, piece: number, settings: SpringSettings): number {
  const grown = settings.damping * tree.mechanics[MECHANICS_SIZE * piece + MECHANICS.DAMPING];
  return within(levelOf(tree, piece, settings)?.damping ?? grown, DAMPING);
}

/** How far a stem whose tip is bent by 1 is aside at the part z of its length, in lengths: the integral of z^1.8, the bend's share. */
const aside = (z: number): number => (z > 0 ? z ** 2.8 / 2.8 : 0);

/**
 * Every piece of a tree as a spring: a texel array of SPRING_LAYERS, as wide and high as the pieces; `out` is overwritten where given.
 *
 * `stiffness` is that of the wind document, `dt` the seconds of a step. Source: equations.md 6.8.
 */
export function springTexels(
  tree: SpringTree,
  settings: SpringSettings,
  stiffness = 1,
  dt = 1 / SPRING_RATE,
  out: TexelArray = texelArray(tree.pieceCount, Object.keys(SPRING_LAYERS).length),
): TexelArray {
  const { data } = out;
  const { mechanics } = tree;
  const frame = layerStart(out, SPRING_LAYERS.FRAME);
  const step = layerStart(out, SPRING_LAYERS.STEP);
  const load = layerStart(out, SPRING_LAYERS.LOAD);
  for (let i = 0; i < tree.pieceCount; i++) {
    const t = 4 * i;
    const at = MECHANICS_SIZE * i;
    const omega = springOmega(tree, i, settings, stiffness);
    const length = mechanics[at + MECHANICS.LENGTH];
    const bent = aside(mechanics[at + MECHANICS.Z1]) - aside(mechanics[at + MECHANICS.Z0]);
    writeFrame(tree.restPose, i, data, frame + t);
    data.set(springTransition(omega, springDamping(tree, i, settings), dt), step + t);
    data[load + t] = 1.5 / (Math.max(length, 1e-6) * omega * omega);
    data[load + t + 1] = (length * bent * mechanics[at + MECHANICS.FLEXIBILITY]) / stiffness;
    data[load + t + 2] = omega;
    data[load + t + 3] = 0;
  }
  return out;
}

const columns = new Float64Array(9);

/** The base frame (L, T, S) of piece i at rest, as a quaternion. */
function writeFrame({ data, width, height }: TexelArray, i: number, out: Float32Array, at: number): void {
  const plane = layerStart({ width, height }, 1);
  const p0 = POSE_TARGETS.P0 * plane + 4 * i;
  const p1 = POSE_TARGETS.P1 * plane + 4 * i;
  const p2 = POSE_TARGETS.P2 * plane + 4 * i;
  const l = unit([data[p1] - data[p0], data[p1 + 1] - data[p0 + 1], data[p1 + 2] - data[p0 + 2]]);
  const o: Vec3 = [data[p0 + 3], data[p1 + 3], data[p2 + 3]];
  const t = across(l, o);
  writeColumns(columns, l[0], l[1], l[2], t[0], t[1], t[2]);
  writeQuaternion(columns, out, at);
}
