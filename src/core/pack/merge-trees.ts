import { groveExtent, treeTexels } from './grove-extent.ts';
import { shareOut } from './grove-order.ts';
import { BRANCH_LAYERS, MECHANICS, MECHANICS_SIZE, PIECE_LAYERS, POSE_TARGETS, TEXEL } from './layout.ts';
import { GROVE_PIECE_BITS, GROVE_PIECES, GROVE_TREES } from './leaf-texel.ts';
import type { DrawRange, PackedTree, TexelArray } from './packed.ts';
import { layerStart, texelArray, wordTexels } from './texel-array.ts';
import { turnOf } from './turn.ts';

/** A tree and where it stands in its grove: metres, radians from x to y. */
export interface Standing {
  readonly tree: PackedTree;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly turn: number;
  /** Turns added to the phases of its stems' swaying, so that trees of one seed do not swing in unison; 0 by default. */
  readonly phase?: number;
}

/** Several trees as one: one wind pass moves them, and one draw a level draws them. */
export interface PackedGrove extends PackedTree {
  /** Layers of TREE_LAYERS. */
  readonly trees: TexelArray;
  readonly treeCount: number;
}

/** Where the pieces of one tree come to. */
interface Placed extends Standing {
  readonly index: number;
  readonly cos: number;
  readonly sin: number;
  /** Added to the number of a piece of each depth. */
  readonly shift: Int32Array;
}

const sum = (numbers: readonly number[]): number => numbers.reduce((a, b) => a + b, 0);

/**
 * Merges trees of one species into one packed tree, in grove space (z up), each turned and moved to its place.
 *
 * Pieces are sorted by depth and then by tree. Any prefix of a level, and of the leaves, is spread evenly over all trees. The wind is
 * felt where a stem's tip is, along the ground; its height is that above the tree's own foot, as the wind's profile wants it.
 * `leafLength` is the mean over the leaves, TREE_LAYERS says each tree's own. Throws RangeError where there is no tree, or more than
 * 2048 of them, or more than 2^20 pieces.
 */
export function mergeTrees(standings: readonly Standing[]): PackedGrove {
  const pieceCount = sum(standings.map(({ tree }) => tree.pieceCount));
  const leafCount = sum(standings.map(({ tree }) => tree.leafCount));
  if (standings.length === 0) throw new RangeError('A grove needs at least one tree.');
  if (standings.length > GROVE_TREES || pieceCount > GROVE_PIECES) {
    throw new RangeError(
      `A grove of ${standings.length} trees with ${pieceCount} pieces is too large: ${GROVE_TREES} trees and ${GROVE_PIECES} pieces are allowed. Divide it into smaller groves.`,
    );
  }
  const depthStart = depthsOf(standings.map(({ tree }) => tree));
  const placed = place(standings, depthStart);
  const levels = levelsOf(standings.map(({ tree }) => tree));
  const pieces = texelArray(pieceCount, Object.keys(PIECE_LAYERS).length);
  const restPose = texelArray(pieceCount, Object.keys(POSE_TARGETS).length);
  const mechanics = new Float32Array(MECHANICS_SIZE * pieceCount);
  for (const each of placed) {
    copyPieces(each, pieces, mechanics);
    copyPose(each, restPose);
  }
  const leafLength = leafCount > 0 ? sum(standings.map(({ tree }) => tree.leafLength * tree.leafCount)) / leafCount : 0;
  return {
    pieceCount,
    leafCount,
    depthStart,
    pieces,
    restPose,
    branches: mergeBranches(placed, levels, pieceCount),
    leaves: mergeLeaves(placed, leafCount),
    mechanics,
    leafLength,
    levels,
    trees: treeTexels(standings, leafLength),
    treeCount: standings.length,
    ...(standings.some(({ tree }) => tree.cards) ? { cards: true } : {}),
    ...groveExtent(standings),
  };
}

/** Pieces of a tree that have this depth. */
const countAt = ({ depthStart }: PackedTree, depth: number): number =>
  depth + 1 < depthStart.length ? (depthStart[depth + 1] as number) - (depthStart[depth] as number) : 0;

function depthsOf(trees: readonly PackedTree[]): Uint32Array {
  const depths = Math.max(...trees.map(({ depthStart }) => depthStart.length - 1));
  const out = new Uint32Array(depths + 1);
  for (let d = 0; d < depths; d++) out[d + 1] = (out[d] as number) + sum(trees.map((tree) => countAt(tree, d)));
  return out;
}

function place(standings: readonly Standing[], depthStart: Uint32Array): Placed[] {
  const next = depthStart.slice();
  return standings.map((standing, index) => {
    const { tree, turn } = standing;
    const shift = new Int32Array(tree.depthStart.length - 1);
    for (let d = 0; d < shift.length; d++) {
      shift[d] = (next[d] as number) - (tree.depthStart[d] as number);
      next[d] = (next[d] as number) + countAt(tree, d);
    }
    const [cos, sin] = turnOf(turn);
    return { ...standing, index, shift, cos, sin };
  });
}

function levelsOf(trees: readonly PackedTree[]): DrawRange[] {
  const most = Math.max(...trees.map(({ levels }) => levels.length));
  const out: DrawRange[] = [];
  let start = 0;
  for (let level = 0; level < most; level++) {
    const count = sum(trees.map(({ levels }) => levels[level]?.count ?? 0));
    out.push({ start, count });
    start += count;
  }
  return out;
}

/** Rows of the wind pass and of the mechanics, depth by depth: what does not know where it stands is copied as it is. */
function copyPieces(
  { tree, shift, x, y, cos, sin, turn, phase = 0 }: Placed,
  out: TexelArray,
  mechanics: Float32Array,
) {
  const { data } = tree.pieces;
  const [whole, half] = turnOf(turn / 2);
  for (let d = 0; d < shift.length; d++) {
    const [from, to] = [tree.depthStart[d] as number, tree.depthStart[d + 1] as number];
    const by = shift[d] as number;
    for (let layer = 0; layer < out.layers; layer++) {
      const start = layerStart(tree.pieces, layer);
      out.data.set(
        data.subarray(start + TEXEL * from, start + TEXEL * to),
        layerStart(out, layer) + TEXEL * (from + by),
      );
    }
    mechanics.set(tree.mechanics.subarray(MECHANICS_SIZE * from, MECHANICS_SIZE * to), MECHANICS_SIZE * (from + by));
    const attach = layerStart(out, PIECE_LAYERS.ATTACH);
    const orient = layerStart(out, PIECE_LAYERS.ORIENT);
    const tip = layerStart(out, PIECE_LAYERS.TIP);
    const parents = d > 0 ? (shift[d - 1] as number) : 0;
    for (let i = from + by; i < to + by; i++) {
      const t = TEXEL * i;
      const a = attach + t;
      if ((out.data[a] as number) >= 0) out.data[a] = (out.data[a] as number) + parents;
      else turnQuaternion(out.data, orient + t, half, whole);
      const [tx, ty] = [out.data[tip + t] as number, out.data[tip + t + 1] as number];
      out.data[tip + t] = cos * tx - sin * ty + x;
      out.data[tip + t + 1] = sin * tx + cos * ty + y;
      const m = MECHANICS_SIZE * i + MECHANICS.PHASE;
      const sway = (mechanics[m] as number) + phase;
      if (phase !== 0) mechanics[m] = sway - Math.floor(sway);
    }
  }
}

/** A rotation followed by one about z, of which `half` and `whole` are the sine and cosine of half the angle. */
function turnQuaternion(data: Float32Array, at: number, half: number, whole: number): void {
  const [x, y, z, w] = data.subarray(at, at + 4) as unknown as [number, number, number, number];
  data[at] = whole * x - half * y;
  data[at + 1] = whole * y + half * x;
  data[at + 2] = whole * z + half * w;
  data[at + 3] = whole * w - half * z;
}

function copyPose({ tree, shift, x, y, z, cos, sin }: Placed, out: TexelArray): void {
  const { data } = tree.restPose;
  const to = out.data;
  const starts = [0, 1, 2, 3].map((k) => layerStart(tree.restPose, k)) as [number, number, number, number];
  const ends = [0, 1, 2, 3].map((k) => layerStart(out, k)) as [number, number, number, number];
  for (let d = 0; d < shift.length; d++) {
    const by = TEXEL * (shift[d] as number);
    const last = TEXEL * (tree.depthStart[d + 1] as number);
    for (let t = TEXEL * (tree.depthStart[d] as number); t < last; t += TEXEL) {
      for (let k = 0; k < 4; k++) {
        const from = (starts[k] as number) + t;
        const at = (ends[k] as number) + t + by;
        const [px, py] = [data[from] as number, data[from + 1] as number];
        to[at] = cos * px - sin * py + x;
        to[at + 1] = sin * px + cos * py + y;
        to[at + 2] = (data[from + 2] as number) + z;
      }
      // The orientation vector stands in the fourth numbers.
      const [ox, oy] = [data[starts[0] + t + 3] as number, data[starts[1] + t + 3] as number];
      to[ends[0] + t + by + 3] = cos * ox - sin * oy;
      to[ends[1] + t + by + 3] = sin * ox + cos * oy;
      to[ends[2] + t + by + 3] = data[starts[2] + t + 3] as number;
      to[ends[3] + t + by + 3] = data[starts[3] + t + 3] as number;
    }
  }
}

function mergeBranches(placed: readonly Placed[], levels: readonly DrawRange[], count: number): TexelArray {
  const out = texelArray(count, Object.keys(BRANCH_LAYERS).length);
  const span = layerStart(out, BRANCH_LAYERS.SPAN);
  const stem = layerStart(out, BRANCH_LAYERS.STEM);
  const joint = layerStart(out, BRANCH_LAYERS.JOINT);
  levels.forEach(({ start }, level) => {
    const counts = placed.map(({ tree }) => tree.levels[level]?.count ?? 0);
    shareOut(counts, (index, first, run, at) => {
      const { tree, shift } = placed[index] as Placed;
      const from = TEXEL * ((tree.levels[level] as DrawRange).start + first);
      const to = TEXEL * (start + at);
      for (let layer = 0; layer < out.layers; layer++) {
        const begin = layerStart(tree.branches, layer) + from;
        out.data.set(tree.branches.data.subarray(begin, begin + TEXEL * run), layerStart(out, layer) + to);
      }
      for (let t = to; t < to + TEXEL * run; t += TEXEL) {
        const depth = out.data[stem + t + 2] as number;
        out.data[span + t] = (out.data[span + t] as number) + (shift[depth] as number);
        out.data[joint + t + 3] = index;
      }
    });
  });
  return out;
}

function mergeLeaves(placed: readonly Placed[], count: number): TexelArray<Uint32Array> {
  const out = wordTexels(count, 1);
  // Where each piece of a tree comes to; its depth is told by where it stands.
  const moved = placed.map(({ tree, shift }) => {
    const to = new Uint32Array(tree.pieceCount);
    for (let d = 0; d < shift.length; d++) {
      const last = tree.depthStart[d + 1] as number;
      for (let i = tree.depthStart[d] as number; i < last; i++) to[i] = i + (shift[d] as number);
    }
    return to;
  });
  shareOut(
    placed.map(({ tree }) => tree.leafCount),
    (index, first, run, at) => {
      const { data } = (placed[index] as Placed).tree.leaves;
      const to = moved[index] as Uint32Array;
      out.data.set(data.subarray(TEXEL * first, TEXEL * (first + run)), TEXEL * at);
      const last = TEXEL * (at + run);
      for (let t = TEXEL * at; t < last; t += TEXEL) {
        const word = out.data[t] as number;
        out.data[t] = (word & 0x80000000) | (index << GROVE_PIECE_BITS) | (to[word & 0x7fffffff] as number);
      }
    },
  );
  return out;
}
