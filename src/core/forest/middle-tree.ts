import { bezierPoint, type Cubic } from '../math/bezier.ts';
import { handlesOf, sectionFrame } from '../math/frames.ts';
import { hashPcg, hashUnit } from '../math/hash.ts';
import { dot, subtract, type Vec3 } from '../math/vec3.ts';
import { CARD_PICTURES, writeCard } from '../pack/card-texel.ts';
import { BRANCH_LAYERS, MECHANICS, MECHANICS_SIZE, PIECE_LAYERS, TEXEL } from '../pack/layout.ts';
import type { DrawRange, PackedTree, TexelArray } from '../pack/packed.ts';
import { layerStart, texelArray, wordTexels } from '../pack/texel-array.ts';
import { unpackPose } from '../pack/unpack.ts';
import type { Species } from '../species/species.ts';
import { type Clumps, clumpsOf, STEM_LEVELS } from './clumps.ts';

/** What a leaf reaches beyond its foot, in blades: cards are that much larger than the clump of the feet. */
export const LEAF_REACH = 0.8;

/**
 * The tree as it is drawn at a middle distance: its stems of levels 0 and 1, and clump cards in place of leaves and twigs
 * (`cards` of PackedTree; `card-texel.ts` reads them). It moves by the same wind pass as the full tree, those stems alike.
 */
export function middleTree(tree: PackedTree, species: Species, clumps: Clumps = clumpsOf(tree)): PackedTree {
  const to = keptPieces(tree);
  const pieceCount = to.reduce((n, i) => n + (i >= 0 ? 1 : 0), 0);
  const levels = tree.levels.slice(0, STEM_LEVELS);
  const mechanics = new Float32Array(MECHANICS_SIZE * pieceCount);
  to.forEach((at, i) => {
    if (at >= 0)
      mechanics.set(tree.mechanics.subarray(MECHANICS_SIZE * i, MECHANICS_SIZE * (i + 1)), MECHANICS_SIZE * at);
  });
  const pieces = kept(tree.pieces, to, pieceCount);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  for (let i = 0; i < pieceCount; i++) {
    const parent = pieces.data[attach + TEXEL * i]!;
    if (parent >= 0) pieces.data[attach + TEXEL * i] = to[parent]!;
  }
  return {
    ...tree,
    pieceCount,
    leafCount: clumps.count,
    depthStart: depthsOf(tree.depthStart, to),
    pieces,
    restPose: kept(tree.restPose, to, pieceCount),
    branches: keptBranches(tree.branches, levels, to),
    leaves: cards(tree, species, clumps, to),
    mechanics,
    levels,
    cards: true,
  };
}

/** The clumps that stand for all of a tree in its pictures, the thinnest first. */
export function pictureClumps(clumps: Clumps): number[] {
  const order = byDensity(clumps);
  return Array.from(
    { length: CARD_PICTURES },
    (_, k) => order[Math.floor(((k + 0.5) / CARD_PICTURES) * order.length)] ?? -1,
  );
}

/** Clumps by how many leaves stand behind each other in them. */
const byDensity = ({ size, radius, count }: Clumps): number[] => {
  const dense = (c: number): number => size[c]! / Math.max(1e-6, radius[c]! * radius[c]!);
  return Array.from({ length: count }, (_, c) => c).sort((a, b) => dense(a) - dense(b) || a - b);
};

/** Half of the side of the card of a clump, metres. */
export const cardRadius = ({ radius }: Clumps, clump: number, tree: PackedTree, { foliage }: Species): number =>
  radius[clump]! + LEAF_REACH * tree.leafLength * foliage.size;

/** New index of each piece, -1 of those that go. */
function keptPieces({ pieceCount, mechanics }: PackedTree): Int32Array {
  const to = new Int32Array(pieceCount);
  let next = 0;
  for (let i = 0; i < pieceCount; i++)
    to[i] = mechanics[MECHANICS_SIZE * i + MECHANICS.LEVEL]! < STEM_LEVELS ? next++ : -1;
  return to;
}

function kept(array: TexelArray, to: Int32Array, count: number): TexelArray {
  const out = texelArray(count, array.layers);
  for (let layer = 0; layer < array.layers; layer++) {
    const from = layerStart(array, layer);
    const start = layerStart(out, layer);
    to.forEach((at, i) => {
      if (at >= 0) out.data.set(array.data.subarray(from + TEXEL * i, from + TEXEL * (i + 1)), start + TEXEL * at);
    });
  }
  return out;
}

/** First piece of each depth that is left; depths without any are left out, and they are the last ones. */
function depthsOf(depthStart: Uint32Array, to: Int32Array): Uint32Array {
  const out = [0];
  for (let d = 0; d + 1 < depthStart.length; d++) {
    let n = 0;
    for (let i = depthStart[d]!; i < depthStart[d + 1]!; i++) if (to[i]! >= 0) n++;
    if (n > 0) out.push(out[out.length - 1]! + n);
  }
  return Uint32Array.from(out);
}

/** The first levels of the draw order: they stand first in it. */
function keptBranches(branches: TexelArray, levels: readonly DrawRange[], to: Int32Array): TexelArray {
  const count = levels.reduce((sum, level) => sum + level.count, 0);
  const out = texelArray(count, branches.layers);
  for (let layer = 0; layer < branches.layers; layer++) {
    const from = layerStart(branches, layer);
    out.data.set(branches.data.subarray(from, from + TEXEL * count), layerStart(out, layer));
  }
  const span = layerStart(out, BRANCH_LAYERS.SPAN);
  for (let i = 0; i < count; i++) out.data[span + TEXEL * i] = to[out.data[span + TEXEL * i]!]!;
  return out;
}

function cards(tree: PackedTree, species: Species, clumps: Clumps, to: Int32Array): TexelArray<Uint32Array> {
  const out = wordTexels(clumps.count, 1);
  const rank = new Uint32Array(clumps.count);
  byDensity(clumps).forEach((c, k) => {
    rank[c] = k;
  });
  for (let c = 0; c < clumps.count; c++) {
    const piece = clumps.carrier[c]!;
    const { points, orient } = unpackPose(tree.restPose, piece);
    const curve: Cubic = { p0: points[0], p1: points[1], p2: points[2], p3: points[3] };
    const v = clumps.v[c]!;
    const middle: Vec3 = [clumps.centre[3 * c]!, clumps.centre[3 * c + 1]!, clumps.centre[3 * c + 2]!];
    const away = subtract(middle, bezierPoint(curve, v));
    const [along, t, s] = sectionFrame(curve, handlesOf(curve, orient), v);
    writeCard(out.data, c, {
      piece: to[piece]!,
      odd: depthOf(tree.depthStart, piece) % 2 === 1,
      v,
      phase: hashUnit(hashPcg(c ^ 0x63617264)),
      offset: [dot(away, along), dot(away, t), dot(away, s)],
      radius: cardRadius(clumps, c, tree, species),
      picture: Math.floor((rank[c]! / clumps.count) * CARD_PICTURES),
    });
  }
  return out;
}

const depthOf = (depthStart: Uint32Array, piece: number): number => {
  let d = 0;
  while (d + 1 < depthStart.length && depthStart[d + 1]! <= piece) d++;
  return d;
};
