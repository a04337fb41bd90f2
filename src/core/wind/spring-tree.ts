import { PIECE_LAYERS, SPRING_LAYERS, STATE_TARGETS } from '../pack/layout.ts';
import type { PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { bendVector } from './bend.ts';
import { windForce } from './force.ts';
import type { WindToPose } from './push.ts';
import { SPRING_RATE } from './spring.ts';

/** What a step of the springs reads of the wind; `spring.inertia` alone of the settings, the others are in the texels. */
export interface WindToSpring extends WindToPose {
  spring: { readonly inertia: number };
}

/** What a step of the springs reads of a tree. */
export type PiecesToSpring = Pick<PackedTree, 'pieceCount' | 'pieces'>;

/** Floats of a state: three targets, laid out as STATE_TARGETS. */
export const stateLength = (texels: TexelArray): number => Object.keys(STATE_TARGETS).length * layerStart(texels, 1);

/**
 * The state of all springs of a tree at time 0: every stem bent as far as the wind of that time pushes it, and still.
 * `texels`: layers of SPRING_LAYERS. Source: `springStart`. Twin: shaders/wind/spring.frag.
 */
export function startSprings(
  tree: PiecesToSpring,
  texels: TexelArray,
  wind: WindToSpring,
  out: Float32Array = new Float32Array(stateLength(texels)),
): Float32Array {
  return advance(tree, texels, wind, null, out);
}

/**
 * The state of all springs one step of 1/60 s after `previous`; `wind` is that of the middle of the step, `out` another array.
 *
 * A piece is shaken by what its parent did in the step before: accelerations run up the tree and never around in it, so that each link
 * is as stable as one spring. Numbers are written out so that hardly anything is allocated for a piece; a test holds it to
 * `springStep`. Twin: shaders/wind/spring.frag.
 */
export function stepSprings(
  tree: PiecesToSpring,
  texels: TexelArray,
  wind: WindToSpring,
  previous: Float32Array,
  out: Float32Array = new Float32Array(previous.length),
): Float32Array {
  return advance(tree, texels, wind, previous, out);
}

function advance(
  { pieceCount, pieces }: PiecesToSpring,
  texels: TexelArray,
  wind: WindToSpring,
  previous: Float32Array | null,
  out: Float32Array,
): Float32Array {
  const { data } = pieces;
  const springs = texels.data;
  const plane = layerStart(texels, 1);
  const attach = PIECE_LAYERS.ATTACH * plane;
  const tips = PIECE_LAYERS.TIP * plane;
  const base = STATE_TARGETS.BASE * plane;
  const end = STATE_TARGETS.END * plane;
  for (let i = 0; i < pieceCount; i++) {
    const t = 4 * i;
    const tip = tips + t;
    const force = windForce(wind, data[tip], data[tip + 1], data[tip + 2]);
    const beta = bendVector(force[0], force[1], data[tip + 3], wind.forceExponent, wind.lengthExponent);
    const r = SPRING_LAYERS.FRAME * plane + t;
    const x = springs[r];
    const y = springs[r + 1];
    const z = springs[r + 2];
    const w = springs[r + 3];
    // The columns T and S of the frame at rest.
    const tx = 2 * (x * y - w * z);
    const ty = 1 - 2 * (x * x + z * z);
    const tz = 2 * (y * z + w * x);
    const sx = 2 * (x * z + w * y);
    const sy = 2 * (y * z - w * x);
    const sz = 1 - 2 * (x * x + y * y);
    const along = (1 - 2 * (y * y + z * z)) * beta[0] + 2 * (x * y + w * z) * beta[1];
    let targetT = tx * beta[0] + ty * beta[1];
    let targetS = sx * beta[0] + sy * beta[1];
    let ax = 0;
    let ay = 0;
    let az = 0;
    const q = STATE_TARGETS.Q * plane + t;
    if (previous === null) {
      out[q] = targetT;
      out[q + 1] = targetS;
      out[q + 2] = 0;
      out[q + 3] = 0;
    } else {
      const parent = data[attach + t];
      const load = SPRING_LAYERS.LOAD * plane + t;
      if (parent >= 0) {
        const v = data[attach + t + 1];
        const b = base + 4 * parent;
        const e = end + 4 * parent;
        ax = previous[b] * (1 - v) + previous[e] * v;
        ay = previous[b + 1] * (1 - v) + previous[e + 1] * v;
        az = previous[b + 2] * (1 - v) + previous[e + 2] * v;
        const lever = springs[load] * wind.spring.inertia;
        const at = tx * ax + ty * ay + tz * az;
        const as = sx * ax + sy * ay + sz * az;
        const thrown = lever / Math.max(1, Math.abs(lever) * Math.sqrt(at * at + as * as));
        targetT -= thrown * at;
        targetS -= thrown * as;
      }
      const step = SPRING_LAYERS.STEP * plane + t;
      const b11 = springs[step];
      const b12 = springs[step + 1];
      const b21 = springs[step + 2];
      const b22 = springs[step + 3];
      const qt = previous[q] - targetT;
      const qs = previous[q + 1] - targetS;
      const vt = previous[q + 2];
      const vs = previous[q + 3];
      const fasterT = b21 * qt + b22 * vt;
      const fasterS = b21 * qs + b22 * vs;
      out[q] = previous[q] + b11 * qt + b12 * vt;
      out[q + 1] = previous[q + 1] + b11 * qs + b12 * vs;
      out[q + 2] = vt + fasterT;
      out[q + 3] = vs + fasterS;
      const swung = SPRING_RATE * springs[load + 1];
      out[end + t] = ax + swung * (tx * fasterT + sx * fasterS);
      out[end + t + 1] = ay + swung * (ty * fasterT + sy * fasterS);
      out[end + t + 2] = az + swung * (tz * fasterT + sz * fasterS);
    }
    if (previous === null) out.fill(0, end + t, end + t + 3);
    out[base + t] = ax;
    out[base + t + 1] = ay;
    out[base + t + 2] = az;
    out[base + t + 3] = Math.sqrt(force[0] * force[0] + force[1] * force[1]);
    out[end + t + 3] = along;
  }
  return out;
}

/** The state between two steps, f from the first to the second. Source: `mixSpring`. */
export function mixSprings(
  a: Float32Array,
  b: Float32Array,
  f: number,
  out: Float32Array = new Float32Array(a.length),
): Float32Array {
  for (let i = 0; i < a.length; i++) out[i] = a[i] * (1 - f) + b[i] * f;
  return out;
}
