import { BRANCH_LAYERS, PIECE_LAYERS, POSE_TARGETS } from './layout.ts';
import type { PackedTree, TexelArray } from './packed.ts';
import { layerStart } from './texel-array.ts';

/** The texel of a layer as four numbers. */
const texel = (array: TexelArray, layer: number, index: number): [number, number, number, number] => {
  const at = layerStart(array, layer) + 4 * index;
  const { data } = array;
  return [data[at], data[at + 1], data[at + 2], data[at + 3]];
};

type Three = [number, number, number];

/** What the wind pass reads of one piece. */
export interface UnpackedPiece {
  parent: number;
  v: number;
  /** Bend weights of P2 and P3, flexibility included. */
  weights: [number, number];
  orientation: [number, number, number, number];
  p1: Three;
  p2: Three;
  p3: Three;
  arc: number;
  tip: Three;
  third: number;
}

/** One piece by index. For tests and tools: it allocates. */
export function unpackPiece({ pieces }: PackedTree, index: number): UnpackedPiece {
  const [parent, v, w2, w3] = texel(pieces, PIECE_LAYERS.ATTACH, index);
  const [x2, y2, z2, x1] = texel(pieces, PIECE_LAYERS.HANDLE, index);
  const [x3, y3, z3, arc] = texel(pieces, PIECE_LAYERS.END, index);
  const [tx, ty, tz, third] = texel(pieces, PIECE_LAYERS.TIP, index);
  return {
    parent,
    v,
    weights: [w2, w3],
    orientation: texel(pieces, PIECE_LAYERS.ORIENT, index),
    p1: [x1, 0, 0],
    p2: [x2, y2, z2],
    p3: [x3, y3, z3],
    arc,
    tip: [tx, ty, tz],
    third,
  };
}

/** Control points and orientation vector of one piece in a pose. */
export interface UnpackedPose {
  points: [Three, Three, Three, Three];
  orient: Three;
  /** Angle of the piece's bend in radians; 0 at rest. */
  bend: number;
}

/** One piece of a pose: the rest pose of a tree, or one read back from the GPU in the same layout. */
export function unpackPose(pose: TexelArray, index: number): UnpackedPose {
  const [x0, y0, z0, ox] = texel(pose, POSE_TARGETS.P0, index);
  const [x1, y1, z1, oy] = texel(pose, POSE_TARGETS.P1, index);
  const [x2, y2, z2, oz] = texel(pose, POSE_TARGETS.P2, index);
  const [x3, y3, z3, bend] = texel(pose, POSE_TARGETS.P3, index);
  return {
    points: [
      [x0, y0, z0],
      [x1, y1, z1],
      [x2, y2, z2],
      [x3, y3, z3],
    ],
    orient: [ox, oy, oz],
    bend,
  };
}

/** What the branch deformer reads at one place of the draw order. */
export interface UnpackedBranch {
  piece: number;
  z0: number;
  z1: number;
  baseRadius: number;
  length: number;
  phase: number;
  depth: number;
  parentRadius: number;
  /** Along L, T and S of the piece. */
  parentAxis: readonly [number, number, number];
}

/** One branch by its place in the draw order. */
export function unpackBranch({ branches }: PackedTree, place: number): UnpackedBranch {
  const [piece, z0, z1, baseRadius] = texel(branches, BRANCH_LAYERS.SPAN, place);
  const [length, phase, depth, parentRadius] = texel(branches, BRANCH_LAYERS.STEM, place);
  const [along, t, s] = texel(branches, BRANCH_LAYERS.JOINT, place);
  return { piece, z0, z1, baseRadius, length, phase, depth, parentRadius, parentAxis: [along, t, s] };
}
