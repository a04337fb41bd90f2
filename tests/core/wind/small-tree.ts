import { arcLength } from '../../../src/core/math/bezier.ts';
import { hashPcg, hashUnit } from '../../../src/core/math/hash.ts';
import type { Quaternion } from '../../../src/core/math/quaternion.ts';
import type { Vec3 } from '../../../src/core/math/vec3.ts';
import { PIECE_LAYERS, POSE_TARGETS } from '../../../src/core/pack/layout.ts';
import { layerStart, texelArray } from '../../../src/core/pack/texel-array.ts';
import { bendWeights } from '../../../src/core/wind/bend.ts';
import { createWindState } from '../../../src/core/wind/fade.ts';
import { type PiecesToPose, planeOf, poseOf, poseTreePlainly } from '../../../src/core/wind/pose-plainly.ts';

/** A piece to make: attached to `parent` (-1: the root) at v, or the next of a chain. */
export interface SmallPiece {
  parent: number;
  v: number;
  next: boolean;
  depth: number;
}

export interface SmallTree extends PiecesToPose {
  plan: SmallPiece[];
  maxDepth: number;
}

/** A random tree of `count` pieces, sorted by depth and then by parent, with chains among them; at rest by construction. */
export function smallTree(count: number, seed: number): SmallTree {
  let state = seed;
  const random = (): number => {
    state = hashPcg(state + 1);
    return hashUnit(state);
  };
  const between = (a: number, b: number): number => a + (b - a) * random();
  const plan: SmallPiece[] = [{ parent: -1, v: 0, next: false, depth: 0 }];
  let parent = 0;
  while (plan.length < count) {
    const children = 1 + Math.floor(3 * random());
    for (let k = 0; k < children && plan.length < count; k++) {
      const next = k === 0 && random() < 0.4;
      plan.push({ parent, v: next ? 1 : between(0.1, 1), next, depth: plan[parent].depth + 1 });
    }
    parent++;
  }
  const pieces = texelArray(count, 5);
  const restPose = texelArray(count, 4);
  const put = (layer: number, i: number, texel: number[]): void =>
    pieces.data.set(texel, layerStart(pieces, layer) + 4 * i);
  plan.forEach((piece, i) => {
    const size = 1.5 * 0.7 ** piece.depth;
    const near = (): Vec3 => [size * between(0.8, 1.2), size * between(-0.3, 0.3), size * between(-0.3, 0.3)];
    const p1: Vec3 = [near()[0], 0, 0];
    const [e2, e3] = [near(), near()];
    const p2: Vec3 = [p1[0] + e2[0], e2[1], e2[2]];
    const p3: Vec3 = [p2[0] + e3[0], p2[1] + e3[1], p2[2] + e3[2]];
    const q: Quaternion = [between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)];
    const n = Math.hypot(...q);
    const turned = piece.next ? [0, 0, 0, 1] : q.map((x) => x / n);
    // The root stands upright: x of the base frame to z of the tree.
    put(PIECE_LAYERS.ORIENT, i, i === 0 ? [0, -Math.SQRT1_2, 0, Math.SQRT1_2] : turned);
    const [z0, z1] = piece.next ? [0.5, 1] : [0, plan.some((p) => p.next && p.parent === i) ? 0.5 : 1];
    put(PIECE_LAYERS.ATTACH, i, [piece.parent, piece.v, ...bendWeights(z0, z1)]);
    put(PIECE_LAYERS.HANDLE, i, [...p2, p1[0]]);
    put(PIECE_LAYERS.END, i, [...p3, arcLength({ p0: [0, 0, 0], p1, p2, p3 })]);
    put(PIECE_LAYERS.TIP, i, [0, 0, 0, size * (z1 === 1 ? 1 : 2)]);
  });
  restPose.data.set([2, 1, 0.5], 0);
  const tree: SmallTree = {
    pieceCount: count,
    pieces,
    restPose,
    plan,
    maxDepth: Math.max(...plan.map((p) => p.depth)),
  };
  restPose.data.set(poseTreePlainly(tree, createWindState(), 'exact'));
  // The wind is felt at the tip of the stem: of the last piece of its chain.
  plan.forEach((_, i) => {
    let last = i;
    for (let k = i; k >= 0; k = plan.findIndex((p) => p.next && p.parent === k)) last = k;
    const tip = poseOf(restPose.data, planeOf(restPose), last).curve.p3;
    pieces.data.set(tip, layerStart(pieces, PIECE_LAYERS.TIP) + 4 * i);
  });
  restPose.data.fill(0, layerStart(restPose, POSE_TARGETS.P3 + 1));
  return tree;
}
