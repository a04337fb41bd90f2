import { bezierPoint } from '../math/bezier.ts';
import { LEAF_LAYERS, POSE_TARGETS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart } from '../pack/texel-array.ts';
import { bendVector, weightedPush } from '../wind/bend.ts';
import { attachPiece, attachRoot, bendPose, type Pose } from '../wind/pose.ts';
import { planeOf, poseOf, restPieceOf } from '../wind/pose-plainly.ts';

/** Places of the crown that are followed. */
const FOLLOWED = 120;

/** The wind that is tried, metres: a fresh one. */
const FORCE = 0.5;

/** Exponents of our winds (STILL): p of the force, m of the length. */
const EXPONENTS = [1, 0.6] as const;

/** Pieces and places on them: of leaves, which are spread evenly in their order, else of the ends of branches. */
function places({ leafCount, leaves, pieceCount }: PackedTree): { piece: number; v: number }[] {
  const count = Math.min(FOLLOWED, leafCount || pieceCount);
  const first = layerStart(leaves, LEAF_LAYERS.LEAF);
  return Array.from({ length: count }, (_, i) => {
    if (leafCount === 0) return { piece: Math.floor((i * pieceCount) / count), v: 1 };
    const t = first + TEXEL * i;
    return { piece: leaves.data[t]! & 0x7fffffff, v: (leaves.data[t + 1]! & 0xffff) / 65535 };
  });
}

/**
 * How far a steady force of 1 m carries the top of a crown, metres, where a place at the part z of the height goes z^2 times as far: the
 * least squares of where the leaves of the posed tree go, with all limbs and twigs that give way under them. `height` of the top, metres.
 */
export function crownGive(tree: PackedTree, height: number): number {
  const plane = planeOf(tree.restPose);
  const rest = tree.restPose.data;
  const posed = new Map<number, Pose>();
  /** The pose of a piece, and before it of those that carry it: few of all. */
  const poseIn = (piece: number): Pose => {
    const chain: number[] = [];
    for (let i = piece; i >= 0 && !posed.has(i); i = restPieceOf(tree, i).parent) chain.push(i);
    for (const i of chain.reverse()) {
      const { rest: shape, parent } = restPieceOf(tree, i);
      const carrier = parent < 0 ? undefined : posed.get(parent);
      const placed = carrier
        ? attachPiece(carrier.curve, carrier.o, shape, false)
        : attachRoot(poseOf(rest, plane, i).curve.p0, shape);
      const push = weightedPush(bendVector(FORCE, 0, shape.third, ...EXPONENTS), shape.weights);
      posed.set(i, bendPose(placed, shape, push, 0, false));
    }
    return posed.get(piece)!;
  };
  const z = layerStart(tree.restPose, POSE_TARGETS.P0) + 2;
  const low = tree.pieceCount > 0 ? rest[z]! : 0;
  let along = 0;
  let most = 0;
  for (const { piece, v } of places(tree)) {
    const from = bezierPoint(poseOf(rest, plane, piece).curve, v);
    const part = ((from[2] - low) / Math.max(height - low, 0.01)) ** 2;
    along += part * (bezierPoint(poseIn(piece).curve, v)[0] - from[0]);
    most += part * part;
  }
  return most > 0 ? Math.max(0, along / most / FORCE) : 0;
}
