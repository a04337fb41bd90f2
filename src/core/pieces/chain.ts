import { atan2 } from '../grow/elementary.ts';
import type { Tree } from '../grow/tree.ts';
import { FITTED, fitCubicFree } from './fit.ts';

/** Largest distance between nodes and curve as a fraction of the stem's length: trunks, other levels (equations.md 7.3). */
export const TOLERANCE = [0.01, 0.02] as const;
/** Largest sum of the turns between segments that one piece may follow: 120 degrees (equations.md 7.3). */
export const MAX_TURN = (2 * Math.PI) / 3;
/** Least length of a stem in metres: what is shorter in float32 still gets a direction, that of its frame. */
const SHORTEST = 1e-6;
/** Below this fraction of the tolerance a fit is not improved further. */
const ENOUGH = 0.4;

/** The pieces of every stem in the order of the stems, before they are placed on each other. */
export interface Chains {
  readonly count: number;
  /** First piece of each stem; stems + 1 entries. */
  readonly start: Uint32Array;
  /** P1, P2, P3 relative to P0 in the axes of tree space, 9 a piece. */
  readonly offset: Float64Array;
  /** Part [z0, z1] of the stem's whole length; 2 a piece. */
  readonly span: Float32Array;
  /** Largest distance between the nodes of a stem and its curve, both from the same base, over the length drawn; by level. */
  readonly deviation: Float32Array;
}

/**
 * Fits a chain of cubic Beziers to every stem: the longest prefix that one cubic follows, then the rest, each piece starting
 * in the direction in which the last one ends (equations.md 7.3 and 7.4).
 */
export function fitChains(tree: Tree): Chains {
  const { count, level, zStart, nodeStart, nodePosition, nodeFrame } = tree.stems;
  const start = new Uint32Array(count + 1);
  let offset = new Float64Array(9 * (count + (count >> 2) + 16));
  let span = new Float32Array(2 * (count + (count >> 2) + 16));
  const deviation = new Float32Array(level.reduce((deepest, l) => Math.max(deepest, l + 1), 0));
  let pieces = 0;
  const work = new StemFit();
  for (let i = 0; i < count; i++) {
    start[i] = pieces;
    const node = nodeStart[i];
    const segments = nodeStart[i + 1] - node - 1;
    if (9 * (pieces + segments) > offset.length) {
      offset = enlarged(offset, 9 * (pieces + segments));
      span = enlarged(span, 2 * (pieces + segments));
    }
    const x = nodeFrame[9 * node + 6];
    const y = nodeFrame[9 * node + 7];
    const z = nodeFrame[9 * node + 8];
    if (segments > 1) work.load(nodePosition, node, segments);
    if (segments === 1 || work.length < SHORTEST) {
      straight(nodePosition, node, x, y, z, offset, 9 * pieces);
      span[2 * pieces] = zStart[i];
      span[2 * pieces + 1] = 1;
      pieces++;
      continue;
    }
    const worst = work.fit(TOLERANCE[level[i] === 0 ? 0 : 1], x, y, z);
    const part = (1 - zStart[i]) / segments;
    for (let k = 0; k < work.count; k++, pieces++) {
      for (let j = 0; j < 9; j++) offset[9 * pieces + j] = work.offset[9 * k + j];
      span[2 * pieces] = zStart[i] + part * work.end[k];
      span[2 * pieces + 1] = k + 1 === work.count ? 1 : zStart[i] + part * work.end[k + 1];
    }
    if (worst > deviation[level[i]]) deviation[level[i]] = worst;
  }
  start[count] = pieces;
  return {
    count: pieces,
    start,
    offset: offset.subarray(0, 9 * pieces),
    span: span.subarray(0, 2 * pieces),
    deviation,
  };
}

function enlarged<A extends Float32Array | Float64Array>(old: A, least: number): A {
  const larger = (old instanceof Float64Array ? new Float64Array(2 * least) : new Float32Array(2 * least)) as A;
  larger.set(old);
  return larger;
}

/** A stem of one segment, as most twigs are, or of no length: a straight cubic with even steps. */
function straight(p: Float32Array, node: number, x: number, y: number, z: number, out: Float64Array, at: number): void {
  const a = 3 * node;
  const dx = p[a + 3] - p[a];
  const dy = p[a + 4] - p[a + 1];
  const dz = p[a + 5] - p[a + 2];
  const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
  const third = Math.max(length, SHORTEST) / 3 / Math.sqrt(x * x + y * y + z * z);
  for (let k = 0; k < 3; k++) {
    out[at + 3 * k] = (k + 1) * third * x;
    out[at + 3 * k + 1] = (k + 1) * third * y;
    out[at + 3 * k + 2] = (k + 1) * third * z;
  }
}

/** Least cosine between neighbouring control edges: 105 degrees. */
const FOLD = -0.26;

/**
 * Does the control polygon turn by more than 105 degrees at P1 or P2? Such a cubic may pass near all nodes, but its frames turn
 * over within a hair's breadth: roundings, and the wind, would spin all that hangs on it.
 */
function folds(c: Float64Array): boolean {
  const mx = c[3] - c[0];
  const my = c[4] - c[1];
  const mz = c[5] - c[2];
  const nx = c[6] - c[3];
  const ny = c[7] - c[4];
  const nz = c[8] - c[5];
  const least = FOLD * Math.sqrt(mx * mx + my * my + mz * mz);
  return (
    c[0] * mx + c[1] * my + c[2] * mz < least * Math.sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) ||
    nx * mx + ny * my + nz * mz < least * Math.sqrt(nx * nx + ny * ny + nz * nz)
  );
}

/** The nodes of one stem and the chain fitted to them; its arrays are used again for every stem. */
class StemFit {
  /** Pieces of the chain. */
  count = 0;
  /** P1, P2, P3 relative to P0; 9 a piece. */
  offset = new Float64Array(9 * 16);
  /** Segment at which each piece starts; the entry after the last piece is the number of segments. */
  end = new Int32Array(17);
  /** Length of the polyline in metres. */
  length = 0;
  private segments = 0;
  /** Nodes relative to the first, 3 each. */
  private points = new Float64Array(3 * 17);
  /** Unit direction of each segment, 3 each. */
  private direction = new Float64Array(3 * 16);
  /** Sum of the turns before each segment. */
  private turn = new Float64Array(16);
  private readonly trial = new Float64Array(FITTED);

  load(nodes: Float32Array, first: number, segments: number): void {
    if (segments > this.turn.length) this.reserve(2 * segments);
    this.segments = segments;
    const { points, direction, turn } = this;
    const from = 3 * first;
    for (let j = 0; j < 3 * (segments + 1); j++) points[j] = nodes[from + j] - nodes[from + (j % 3)];
    this.length = 0;
    for (let j = 0; j < segments; j++) {
      const a = 3 * j;
      const x = points[a + 3] - points[a];
      const y = points[a + 4] - points[a + 1];
      const z = points[a + 5] - points[a + 2];
      const step = Math.sqrt(x * x + y * y + z * z);
      const scale = 1 / Math.max(step, 1e-30);
      direction[a] = x * scale;
      direction[a + 1] = y * scale;
      direction[a + 2] = z * scale;
      this.length += step;
      if (j === 0) turn[0] = 0;
      else {
        const cosine =
          direction[a] * direction[a - 3] + direction[a + 1] * direction[a - 2] + direction[a + 2] * direction[a - 1];
        // The arc cosine, but the same on every engine: where a chain splits hangs on it.
        turn[j] = turn[j - 1] + atan2(Math.sqrt(Math.max(0, 1 - cosine * cosine)), cosine);
      }
    }
  }

  /** Fits the chain that starts along (x, y, z); returns the largest distance as a fraction of the length. */
  fit(tolerance: number, x: number, y: number, z: number): number {
    const limit = tolerance * this.length;
    const { segments, turn, trial } = this;
    let scale = 1 / Math.sqrt(x * x + y * y + z * z);
    let worst = 0;
    let from = 0;
    this.count = 0;
    while (from < segments) {
      const tx = x * scale;
      const ty = y * scale;
      const tz = z * scale;
      let most = from + 1;
      while (most < segments && turn[most] - turn[from] <= MAX_TURN) most++;
      let to = most;
      let error = this.tryFit(from, to, tx, ty, tz, limit);
      if (error > limit && to > from + 1) {
        // The error grows with the prefix but for small dips: halve the range instead of trying every length.
        let passes = from + 1;
        let fails = to;
        while (fails - passes > 1) {
          const middle = (passes + fails) >> 1;
          if (this.tryFit(from, middle, tx, ty, tz, limit) > limit) fails = middle;
          else passes = middle;
        }
        to = passes;
        error = this.tryFit(from, to, tx, ty, tz, limit);
      }
      for (let j = 0; j < 9; j++) this.offset[9 * this.count + j] = trial[j];
      this.end[this.count++] = from;
      worst = Math.max(worst, error);
      x = trial[6] - trial[3];
      y = trial[7] - trial[4];
      z = trial[8] - trial[5];
      scale = 1 / Math.sqrt(x * x + y * y + z * z);
      from = to;
    }
    this.end[this.count] = segments;
    return worst / this.length;
  }

  private tryFit(from: number, to: number, x: number, y: number, z: number, limit: number): number {
    const d = this.direction;
    const a = 3 * (to - 1);
    // At an inner node the curve should run between the directions of the segments on both sides.
    const next = to < this.segments ? a + 3 : a;
    let ex = d[a] + d[next];
    let ey = d[a + 1] + d[next + 1];
    let ez = d[a + 2] + d[next + 2];
    const n = Math.sqrt(ex * ex + ey * ey + ez * ez);
    if (n < 1e-6) {
      ex = d[a];
      ey = d[a + 1];
      ez = d[a + 2];
    } else {
      ex /= n;
      ey /= n;
      ez /= n;
    }
    const error = fitCubicFree(this.points, from, to, x, y, z, ex, ey, ez, ENOUGH * limit, this.trial);
    return to > from + 1 && folds(this.trial) ? Number.POSITIVE_INFINITY : error;
  }

  private reserve(segments: number): void {
    this.offset = new Float64Array(9 * segments);
    this.end = new Int32Array(segments + 1);
    this.points = new Float64Array(3 * (segments + 1));
    this.direction = new Float64Array(3 * segments);
    this.turn = new Float64Array(segments);
  }
}
