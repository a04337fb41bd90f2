import { leafPoints } from '../look/leaf-points.ts';
import { LEAF_LAYERS, MECHANICS, MECHANICS_SIZE, PIECE_LAYERS, POSE_TARGETS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';

/** Levels of stems that a middle tree keeps; what is finer is in the pictures of its clumps. */
export const STEM_LEVELS = 2;

/** Leaves to a clump, and how many clumps a tree has at least and at most. */
const LEAVES = 45;
const FEWEST = 60;
const MOST = 200;

/** Points that the middles are found from, and how often each middle moves to that of what is nearest to it. */
const SAMPLE = 4000;
const ROUNDS = 6;

/** The leaves of a tree, with the twigs that bear them, by clumps; index = clump. The same tree has the same clumps. */
export interface Clumps {
  readonly count: number;
  /** Middle and radius of each, tree space, metres: 3 and 1 a clump. The radius holds nearly all of it. */
  readonly centre: Float32Array;
  readonly radius: Float32Array;
  /** Leaves of each; twigs where the tree bears no leaf. */
  readonly size: Uint32Array;
  /** The piece of level 0 or 1 that carries most of it, and where on it. */
  readonly carrier: Int32Array;
  readonly v: Float32Array;
  /** The clump of each place of the leaves' draw order, and of each piece; -1: a stem that no clump holds. */
  readonly ofLeaf: Int16Array;
  readonly ofPiece: Int16Array;
}

/** Where the small things of a tree hang on its large ones. */
interface Carried {
  readonly level: Uint8Array;
  readonly carrier: Int32Array;
  readonly v: Float32Array;
}

/**
 * Finds clumps: the middles start at the first leaves of the draw order, which is spread evenly over the crown, and each moves to the
 * mean of the points that are nearest to it (Lloyd's method). Without leaves the twigs' own middles are the points.
 */
export function clumpsOf(tree: PackedTree): Clumps {
  const carried = carriersOf(tree);
  const leaves = leafPoints(tree, tree.leafCount);
  const twigs = twigPoints(tree, carried.level);
  const points = tree.leafCount > 0 ? leaves : twigs.points;
  const total = points.length / 3;
  const count = Math.min(total, Math.max(FEWEST, Math.min(MOST, Math.round(total / LEAVES))));
  const centre = middles(points, count);
  const ofLeaf = assign(leaves, centre);
  const ofTwig = assign(twigs.points, centre);
  const ofPiece = new Int16Array(tree.pieceCount).fill(-1);
  twigs.piece.forEach((piece, k) => {
    ofPiece[piece] = ofTwig[k]!;
  });
  const sizes = sizesOf(points, tree.leafCount > 0 ? ofLeaf : ofTwig, centre);
  return { count, centre, ...sizes, ...carriedBy(tree, carried, ofLeaf, twigs.piece, ofTwig, count), ofLeaf, ofPiece };
}

/** For every piece its level, and the nearest stem that a middle tree keeps: itself, or what it grows on by way of others. */
function carriersOf({ pieceCount, pieces, mechanics }: PackedTree): Carried {
  const level = new Uint8Array(pieceCount);
  const carrier = new Int32Array(pieceCount);
  const v = new Float32Array(pieceCount);
  const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
  for (let i = 0; i < pieceCount; i++) {
    level[i] = mechanics[MECHANICS_SIZE * i + MECHANICS.LEVEL]!;
    const parent = pieces.data[attach + TEXEL * i]!;
    if (level[i]! < STEM_LEVELS || parent < 0) carrier[i] = i;
    else if (level[parent]! < STEM_LEVELS) {
      carrier[i] = parent;
      v[i] = pieces.data[attach + TEXEL * i + 1]!;
    } else {
      carrier[i] = carrier[parent]!;
      v[i] = v[parent]!;
    }
  }
  return { level, carrier, v };
}

/** Middles of the pieces that a middle tree leaves out, neighbours in the list far apart on the tree. */
function twigPoints(
  { pieceCount, restPose }: PackedTree,
  level: Uint8Array,
): { piece: Int32Array; points: Float32Array } {
  const fine = Array.from({ length: pieceCount }, (_, i) => i).filter((i) => level[i]! >= STEM_LEVELS);
  // A step that shares no factor with the number visits each once.
  let step = Math.max(1, Math.floor(fine.length * 0.618));
  const divisor = (a: number, b: number): number => (b === 0 ? a : divisor(b, a % b));
  while (fine.length > 0 && divisor(step, fine.length) !== 1) step++;
  const piece = Int32Array.from(fine, (_, k) => fine[(k * step) % fine.length]!);
  const points = new Float32Array(3 * piece.length);
  const starts = [POSE_TARGETS.P0, POSE_TARGETS.P1, POSE_TARGETS.P2, POSE_TARGETS.P3].map((t) =>
    layerStart(restPose, t),
  );
  piece.forEach((i, k) => {
    for (let axis = 0; axis < 3; axis++) {
      const [a, b, c, d] = starts.map((start) => restPose.data[start + TEXEL * i + axis]!) as [
        number,
        number,
        number,
        number,
      ];
      points[3 * k + axis] = (a + 3 * b + 3 * c + d) / 8;
    }
  });
  return { piece, points };
}

/** `count` middles among points of which the first are spread evenly. */
function middles(points: Float32Array, count: number): Float32Array {
  const centre = points.slice(0, 3 * count);
  const sample = points.subarray(0, 3 * Math.min(SAMPLE, points.length / 3));
  const sum = new Float64Array(4 * count);
  for (let round = 0; round < ROUNDS; round++) {
    const of = assign(sample, centre);
    sum.fill(0);
    of.forEach((c, i) => {
      for (let k = 0; k < 3; k++) sum[4 * c + k]! += sample[3 * i + k]!;
      sum[4 * c + 3]! += 1;
    });
    for (let c = 0; c < count; c++) {
      const n = sum[4 * c + 3]!;
      for (let k = 0; n > 0 && k < 3; k++) centre[3 * c + k] = sum[4 * c + k]! / n;
    }
  }
  return centre;
}

/** The middle that is nearest to each point; -1 where there is none. */
function assign(points: Float32Array, centre: Float32Array): Int16Array {
  const out = new Int16Array(points.length / 3).fill(-1);
  for (let i = 0; i < out.length; i++) {
    const [x, y, z] = [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
    let best = Infinity;
    for (let c = 0; c < centre.length; c += 3) {
      const [dx, dy, dz] = [centre[c]! - x, centre[c + 1]! - y, centre[c + 2]! - z];
      const d = dx * dx + dy * dy + dz * dz;
      if (d >= best) continue;
      best = d;
      out[i] = c / 3;
    }
  }
  return out;
}

/** How many points each clump has, and its radius: that of the ball whose points lie as far from its middle on the average. */
function sizesOf(
  points: Float32Array,
  of: Int16Array,
  centre: Float32Array,
): { size: Uint32Array; radius: Float32Array } {
  const size = new Uint32Array(centre.length / 3);
  const radius = new Float32Array(centre.length / 3);
  of.forEach((c, i) => {
    size[c]!++;
    for (let k = 0; k < 3; k++) {
      const d = points[3 * i + k]! - centre[3 * c + k]!;
      radius[c]! += d * d;
    }
  });
  for (let c = 0; c < size.length; c++) radius[c] = 1.5 * Math.sqrt(radius[c]! / Math.max(1, size[c]!));
  return { size, radius };
}

/** The stem that carries most of each clump, and the mean place there. */
function carriedBy(
  { leaves, pieceCount }: PackedTree,
  { level, carrier, v }: Carried,
  ofLeaf: Int16Array,
  twigs: Int32Array,
  ofTwig: Int16Array,
  count: number,
): { carrier: Int32Array; v: Float32Array } {
  const votes = Array.from({ length: count }, () => new Map<number, [number, number]>());
  const vote = (clump: number, piece: number, at: number): void => {
    const box = votes[clump]!;
    const had = box.get(piece) ?? [0, 0];
    box.set(piece, [had[0] + 1, had[1] + at]);
  };
  const first = layerStart(leaves, LEAF_LAYERS.LEAF);
  ofLeaf.forEach((clump, i) => {
    const piece = leaves.data[first + TEXEL * i]! & 0x7fffffff;
    const own = level[piece]! < STEM_LEVELS;
    const at = (leaves.data[first + TEXEL * i + 1]! & 0xffff) / 65535;
    vote(clump, own ? piece : carrier[piece]!, own ? at : v[piece]!);
  });
  if (ofLeaf.length === 0)
    twigs.forEach((piece, k) => {
      vote(ofTwig[k]!, carrier[piece]!, v[piece]!);
    });
  const out = { carrier: new Int32Array(count), v: new Float32Array(count) };
  votes.forEach((box, clump) => {
    let most = 0;
    for (const [piece, [n, sum]] of box) {
      if (n <= most || piece >= pieceCount) continue;
      most = n;
      out.carrier[clump] = piece;
      out.v[clump] = sum / n;
    }
  });
  return out;
}
