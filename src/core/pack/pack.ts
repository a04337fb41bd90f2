import { taperRadius } from '../deform/radius.ts';
import type { Tree } from '../grow/tree.ts';
import { hashPcg, hashUnit } from '../math/hash.ts';
import type { LeafAttachments, Pieces } from '../pieces/pieces.ts';
import { bendWeights } from '../wind/bend.ts';
import { extentOf } from './extent.ts';
import { BRANCH_LAYERS, LEAF_LAYERS, PIECE_LAYERS, POSE_TARGETS } from './layout.ts';
import { writeLeaf } from './leaf-texel.ts';
import { packMechanics } from './mechanics.ts';
import type { DrawRange, PackedTree, TexelArray } from './packed.ts';
import { inverseOrder, spreadOrder } from './spread.ts';
import { layerStart, texelArray, wordTexels } from './texel-array.ts';

/**
 * Packs a grown tree into the texel arrays of `layout.ts`.
 *
 * Pieces keep their order (depth, then parent). Branches and leaves get a draw order of which any prefix of a level, or of
 * the leaves, is spread evenly over the tree.
 */
export function packTree(tree: Tree, pieces: Pieces, attachments: LeafAttachments): PackedTree {
  const levels = levelRanges(pieces);
  return {
    pieceCount: pieces.count,
    leafCount: tree.leaves.count,
    depthStart: pieces.depthStart.slice(),
    pieces: packPieces(tree, pieces),
    restPose: packRestPose(pieces),
    branches: packBranches(tree, pieces, levels),
    leaves: packLeaves(tree, pieces, attachments),
    mechanics: packMechanics(tree, pieces),
    leafLength: tree.leaves.count > 0 ? tree.leaves.length[0] : 0,
    levels,
    ...extentOf(tree, pieces, attachments),
  };
}

/** The entry of a list by level: levels beyond the last use the last (weber-penn.md, row 51). */
const byLevel = <T>(list: readonly T[], level: number): T => list[Math.min(level, list.length - 1)];

function packPieces(tree: Tree, pieces: Pieces): TexelArray {
  const out = texelArray(pieces.count, Object.keys(PIECE_LAYERS).length);
  const { data } = out;
  const attach = layerStart(out, PIECE_LAYERS.ATTACH);
  const orient = layerStart(out, PIECE_LAYERS.ORIENT);
  const handle = layerStart(out, PIECE_LAYERS.HANDLE);
  const end = layerStart(out, PIECE_LAYERS.END);
  const tip = layerStart(out, PIECE_LAYERS.TIP);
  const { stems, species } = tree;
  const { count, span, local, next, control, stem } = pieces;
  const lastOfStem = new Int32Array(stems.count);
  for (let i = 0; i < count; i++) if (next[i] < 0) lastOfStem[stem[i]] = i;
  const flexibility = species.wind.stiffness.map((stiffness) => 1 / stiffness);
  for (let i = 0; i < count; i++) {
    const t = 4 * i;
    const [w2, w3] = bendWeights(span[2 * i], span[2 * i + 1]);
    const flexible = byLevel(flexibility, pieces.level[i]);
    data[attach + t] = pieces.parent[i];
    data[attach + t + 1] = pieces.v[i];
    data[attach + t + 2] = flexible * w2;
    data[attach + t + 3] = flexible * w3;
    for (let k = 0; k < 4; k++) data[orient + t + k] = pieces.orientation[t + k];
    const l = 7 * i;
    data[handle + t] = local[l + 1];
    data[handle + t + 1] = local[l + 2];
    data[handle + t + 2] = local[l + 3];
    data[handle + t + 3] = local[l];
    data[end + t] = local[l + 4];
    data[end + t + 1] = local[l + 5];
    data[end + t + 2] = local[l + 6];
    data[end + t + 3] = pieces.arc[i];
    const c = 12 * lastOfStem[stem[i]] + 9;
    data[tip + t] = control[c];
    data[tip + t + 1] = control[c + 1];
    data[tip + t + 2] = control[c + 2];
    data[tip + t + 3] = stems.length[stem[i]] / 3;
  }
  return out;
}

function packRestPose({ count, control, orient }: Pieces): TexelArray {
  const out = texelArray(count, Object.keys(POSE_TARGETS).length);
  for (let point = 0; point < 4; point++) {
    const start = layerStart(out, point);
    for (let i = 0; i < count; i++) {
      const t = start + 4 * i;
      const c = 12 * i + 3 * point;
      out.data[t] = control[c];
      out.data[t + 1] = control[c + 1];
      out.data[t + 2] = control[c + 2];
      out.data[t + 3] = point < 3 ? orient[3 * i + point] : 0;
    }
  }
  return out;
}

function levelRanges({ count, level }: Pieces): DrawRange[] {
  const counts: number[] = [];
  for (let i = 0; i < count; i++) {
    while (counts.length <= level[i]) counts.push(0);
    counts[level[i]]++;
  }
  return counts.map((n, l) => ({ start: counts.slice(0, l).reduce((a, b) => a + b, 0), count: n }));
}

function packBranches(tree: Tree, pieces: Pieces, levels: readonly DrawRange[]): TexelArray {
  const out = texelArray(pieces.count, Object.keys(BRANCH_LAYERS).length);
  const span = layerStart(out, BRANCH_LAYERS.SPAN);
  const shape = layerStart(out, BRANCH_LAYERS.STEM);
  const joint = layerStart(out, BRANCH_LAYERS.JOINT);
  const { length, baseRadius, parent } = tree.stems;
  const { phase, radius } = stemStarts(tree);
  const filled = levels.map(() => 0);
  // The pieces of each level in the order of the pieces: neighbours there are neighbours on the tree.
  const sorted = levels.map((range) => new Uint32Array(range.count));
  for (let i = 0; i < pieces.count; i++) sorted[pieces.level[i]][filled[pieces.level[i]]++] = i;
  sorted.forEach((list, level) => {
    const order = spreadOrder(list.length);
    for (let k = 0; k < list.length; k++) {
      const piece = list[order[k]];
      const stem = pieces.stem[piece];
      const t = 4 * (levels[level].start + k);
      out.data[span + t] = piece;
      out.data[span + t + 1] = pieces.span[2 * piece];
      out.data[span + t + 2] = pieces.span[2 * piece + 1];
      out.data[span + t + 3] = baseRadius[stem];
      out.data[shape + t] = length[stem];
      out.data[shape + t + 1] = phase[stem];
      out.data[shape + t + 2] = pieces.depth[piece];
      out.data[shape + t + 3] = radius[stem];
      if (parent[stem] >= 0 && pieces.firstOfStem[stem] === piece) {
        // The parent's frame has its axis first: what the inverse of the base frame's rotation makes of that.
        const [x, y, z, w] = pieces.orientation.subarray(4 * piece, 4 * piece + 4);
        out.data[joint + t] = 1 - 2 * (y * y + z * z);
        out.data[joint + t + 1] = 2 * (x * y - w * z);
        out.data[joint + t + 2] = 2 * (x * z + w * y);
      }
    }
  });
  return out;
}

/** Phase of the bark of each stem in turns, a clone's being its twin's, and the radius of what it grows on where it starts. */
function stemStarts({ species, stems }: Tree): { phase: Float32Array; radius: Float32Array } {
  const phase = new Float32Array(stems.count);
  const radius = new Float32Array(stems.count);
  for (let i = 0; i < stems.count; i++) {
    const parent = stems.parent[i];
    phase[i] = stems.clone[i] ? phase[parent] : hashUnit(hashPcg(stems.path[i] ^ 0x6261726b));
    if (parent < 0) continue;
    const { taper } = byLevel(species.levels, stems.level[parent]);
    radius[i] = taperRadius(stems.parentZ[i], taper, stems.baseRadius[parent], stems.length[parent])[0];
  }
  return { phase, radius };
}

function packLeaves(
  { leaves }: Tree,
  { depth }: Pieces,
  { piece, v, orientation }: LeafAttachments,
): TexelArray<Uint32Array> {
  const out = wordTexels(leaves.count, Object.keys(LEAF_LAYERS).length);
  // In the leaves' own order: what is read lies in a row, and what is written lies in as many rows as the order has tiers.
  const placeOf = inverseOrder(spreadOrder(leaves.count));
  for (let i = 0; i < leaves.count; i++) {
    const odd = (depth[piece[i]] & 1) === 1;
    writeLeaf(out.data, placeOf[i], piece[i], odd, v[i], leaves.phase[i], orientation, 4 * i);
  }
  return out;
}
