import { arcLength } from '../../core/math/bezier.ts';
import { addScaled, distance, type Vec3 } from '../../core/math/vec3.ts';
import {
  BRANCH_LAYERS,
  LEAF_LAYERS,
  MECHANICS,
  MECHANICS_SIZE,
  PIECE_LAYERS,
  POSE_TARGETS,
} from '../../core/pack/layout.ts';
import { writeLeaf } from '../../core/pack/leaf-texel.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart, texelArray, wordTexels } from '../../core/pack/texel-array.ts';
import { bendWeights } from '../../core/wind/bend.ts';
import { createWindState } from '../../core/wind/fade.ts';
import { planeOf, poseOf, poseTreePlainly } from '../../core/wind/pose-plainly.ts';
import { between, near, type Random, randomStream, rotation } from './random.ts';

/** First piece of each depth: a root for about 4 000 pieces, then each depth `growth` times the one before. */
function depthsOf(pieceCount: number, depths: number): Uint32Array {
  const roots = Math.max(1, Math.round(pieceCount / 4000));
  const used = Math.min(depths, pieceCount);
  // Solve roots (1 + g + g^2 + ...) = pieceCount by bisection.
  let [low, high] = [1e-3, pieceCount];
  const total = (g: number) => {
    let sum = 0;
    for (let d = 0, n = roots; d < used; d++, n *= g) sum += n;
    return sum;
  };
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (total(middle) < pieceCount) low = middle;
    else high = middle;
  }
  const start = new Uint32Array(used + 1);
  for (let d = 0, n = roots, sum = 0; d < used; d++, n *= low) {
    sum += n;
    start[d + 1] = Math.max(start[d] + 1, Math.round(sum));
  }
  start[used] = pieceCount;
  return start;
}

/**
 * A tree, or a forest, of random pieces: for checks and benches that need a size rather than a species. Same arguments, same
 * tree.
 *
 * Pieces get shorter with depth, every fourth continues its parent at v = 1 as the pieces of a chain do, and parents stand
 * in order, as the packing sorts them. One leaf for each piece of the last depth.
 */
export function syntheticTree(pieceCount: number, depths = 7, seed = 1): PackedTree {
  const random = randomStream(seed);
  const depthStart = depthsOf(pieceCount, depths);
  const pieces = texelArray(pieceCount, Object.keys(PIECE_LAYERS).length);
  const restPose = texelArray(pieceCount, Object.keys(POSE_TARGETS).length);
  for (let depth = 0; depth + 1 < depthStart.length; depth++) {
    for (let i = depthStart[depth]; i < depthStart[depth + 1]; i++) {
      const before = depthStart[Math.max(depth - 1, 0)];
      const share = (i - depthStart[depth]) / (depthStart[depth + 1] - depthStart[depth]);
      const parent = depth === 0 ? -1 : before + Math.floor(share * (depthStart[depth] - before));
      writePiece(pieces.data, planeOf(pieces), i, { random, depth, parent });
      if (depth === 0) restPose.data.set([between(random, -20, 20), between(random, -20, 20), 0, 0], 4 * i);
    }
  }
  const tree = { pieceCount, pieces, restPose };
  poseTreePlainly(tree, createWindState(), 'exact', undefined, restPose.data);
  for (let i = 0; i < pieceCount; i++) {
    const tip = poseOf(restPose.data, planeOf(restPose), i).curve.p3;
    pieces.data.set(tip, layerStart(pieces, PIECE_LAYERS.TIP) + 4 * i);
  }
  return { ...tree, depthStart, mechanics: mechanicsOf(tree, depthStart, seed), ...drawn(tree, depthStart, random) };
}

/** One piece: metres; a child is 0.6 times as long as its parent. */
function writePiece(
  data: Float32Array,
  plane: number,
  i: number,
  { random, depth, parent }: { random: Random; depth: number; parent: number },
): void {
  const edge = 2.2 * 0.6 ** depth * between(random, 0.7, 1.3);
  const p1x = edge;
  const d1 = near(random, [1, 0, 0], 0.5);
  const p2 = addScaled([p1x, 0, 0], d1, edge * between(random, 0.8, 1.2));
  const p3 = addScaled(p2, near(random, d1, 0.5), edge * between(random, 0.8, 1.2));
  const arc = arcLength({ p0: [0, 0, 0], p1: [p1x, 0, 0], p2, p3 });
  const chain = depth > 0 && random() < 0.25;
  const [w2, w3] = bendWeights(0, 1);
  // The root's x axis is its direction: a quarter turn about -y points it up. Children lean away from their parent.
  const up = Math.SQRT1_2;
  const turn = depth === 0 ? [0, -up, 0, up] : chain ? [0, 0, 0, 1] : leaning(random);
  const v = chain ? 1 : between(random, 0.2, 1);
  data.set([parent, v, w2, w3], PIECE_LAYERS.ATTACH * plane + 4 * i);
  data.set(turn, PIECE_LAYERS.ORIENT * plane + 4 * i);
  data.set([...p2, p1x], PIECE_LAYERS.HANDLE * plane + 4 * i);
  data.set([...p3, arc], PIECE_LAYERS.END * plane + 4 * i);
  data.set([0, 0, 0, arc / 3], PIECE_LAYERS.TIP * plane + 4 * i);
}

/** Each piece a stem of its own that swings, the quicker the shorter; chained pieces too, which makes them no easier. */
function mechanicsOf(
  { pieceCount, pieces }: Pick<PackedTree, 'pieceCount' | 'pieces'>,
  depthStart: Uint32Array,
  seed: number,
): Float32Array {
  const random = randomStream(seed + 1);
  const out = new Float32Array(MECHANICS_SIZE * pieceCount);
  const end = layerStart(pieces, PIECE_LAYERS.END);
  for (let depth = 0, i = 0; i < pieceCount; i++) {
    while (i >= depthStart[depth + 1]) depth++;
    const length = pieces.data[end + 4 * i + 3];
    const at = MECHANICS_SIZE * i;
    out[at + MECHANICS.Z1] = 1;
    out[at + MECHANICS.LENGTH] = length;
    out[at + MECHANICS.RADIUS] = length / 40;
    out[at + MECHANICS.OMEGA] = Math.min(12, between(random, 1, 3) / 0.7 ** depth);
    out[at + MECHANICS.LEVEL] = Math.min(depth, 3);
    out[at + MECHANICS.PHASE] = random();
    out[at + MECHANICS.FLEXIBILITY] = 1;
    out[at + MECHANICS.DAMPING] = 1;
  }
  return out;
}

/** A rotation of at most about 70 degrees, half of any rotation. */
function leaning(random: Random): number[] {
  const [x, y, z, w] = rotation(random);
  const s = w < 0 ? -1 : 1;
  const q = [s * x, s * y, s * z, s * w + 1];
  const n = Math.hypot(...q);
  return q.map((part) => part / n);
}

/** What the deformers draw of it: each piece a stem of its own, its radius a fortieth of its length. */
function drawn(
  { pieceCount, pieces, restPose }: Pick<PackedTree, 'pieceCount' | 'pieces' | 'restPose'>,
  depthStart: Uint32Array,
  random: Random,
): Pick<PackedTree, 'branches' | 'leaves' | 'leafCount' | 'leafLength' | 'levels' | 'bounds' | 'crown'> {
  const branches = texelArray(pieceCount, Object.keys(BRANCH_LAYERS).length);
  const depths = depthStart.length - 1;
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  const end = layerStart(pieces, PIECE_LAYERS.END);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  for (let depth = 0, i = 0; i < pieceCount; i++) {
    while (i >= depthStart[depth + 1]) depth++;
    const length = pieces.data[end + 4 * i + 3];
    const parent = pieces.data[attach + 4 * i];
    const parentRadius = parent < 0 ? 0 : pieces.data[end + 4 * parent + 3] / 40;
    branches.data.set([i, 0, 1, length / 40], layerStart(branches, BRANCH_LAYERS.SPAN) + 4 * i);
    branches.data.set([length, random(), depth, parentRadius], layerStart(branches, BRANCH_LAYERS.STEM) + 4 * i);
    const { p3 } = poseOf(restPose.data, planeOf(restPose), i).curve;
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], p3[k]);
      high[k] = Math.max(high[k], p3[k]);
    }
  }
  const first = depthStart[depths - 1];
  const leafCount = pieceCount - first;
  const leaves = wordTexels(leafCount, Object.keys(LEAF_LAYERS).length);
  for (let i = 0; i < leafCount; i++) {
    const odd = (depths - 1) % 2 === 1;
    writeLeaf(leaves.data, i, first + i, odd, random(), random(), rotation(random), 0);
  }
  const centre = low.map((l, k) => (l + high[k]) / 2);
  const radius = distance(low, high) / 2;
  return {
    branches,
    leaves,
    leafCount,
    leafLength: 0.08,
    levels: Array.from({ length: depths }, (_, d) => ({
      start: depthStart[d],
      count: depthStart[d + 1] - depthStart[d],
    })),
    bounds: new Float32Array([...low, ...high]),
    crown: new Float32Array([...centre, radius, radius, radius]),
  };
}
