import { describe, expect, test } from 'vitest';
import { bezierDerivative, type Cubic } from '../../../src/core/math/bezier.ts';
import { handlesOf } from '../../../src/core/math/frames.ts';
import { distance, dot, length, subtract, unit } from '../../../src/core/math/vec3.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { PIECE_LAYERS, POSE_TARGETS } from '../../../src/core/pack/layout.ts';
import type { PackedTree } from '../../../src/core/pack/packed.ts';
import { layerStart } from '../../../src/core/pack/texel-array.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { planeOf, poseOf } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import type { Bends } from '../../../src/core/wind/push.ts';
import { SpringRun } from '../../../src/core/wind/spring-run.ts';
import { swayTexels } from '../../../src/core/wind/sway.ts';
import type { BendModelName, Wind } from '../../../src/core/wind/wind.ts';
import { SHIPPED, shippedSpecies } from '../pack/shipped-species.ts';
import { BEAUFORT_11, galeOf, stateOf } from './some-winds.ts';

/** The species without their leaves, and the willow without the finest of its many twigs. */
function treeOf(name: (typeof SHIPPED)[number]): PackedTree {
  const species = shippedSpecies(name);
  const bare = { ...species, leaves: { ...species.leaves, count: 0 } };
  return growPacked(bare, 1, name === 'weeping-willow' ? { levels: 3 } : {}).packed;
}

/** Arc length by so many steps that no rule of a few nodes stands behind it: Simpson on 120 parts. */
function fineArc(c: Cubic): number {
  let sum = 0;
  for (let i = 0; i <= 120; i++) {
    const weight = i === 0 || i === 120 ? 1 : i % 2 === 1 ? 4 : 2;
    sum += weight * length(bezierDerivative(c, i / 120));
  }
  return sum / 360;
}

/** A wind played to some times, in a model; the springs are those of the whole time up to then. */
function* posesOf(tree: PackedTree, wind: Wind, times: readonly number[]): Generator<Float32Array> {
  const run = new SpringRun(tree, (time, out) => {
    windStateAt(wind, time, undefined, out);
  });
  const sway = swayTexels(tree, wind.sway);
  for (const time of times) {
    const bends: Bends = wind.model === 'spring' ? run.bendsAt(time) : { sway };
    yield poseTree(tree, stateOf(wind, time), 'exact', undefined, undefined, bends);
  }
}

const MODELS: readonly BendModelName[] = ['direct', 'spring', 'sway'];
const GUSTS = [0.4, 2.3];

describe.each(SHIPPED)('%s', (name) => {
  const tree = treeOf(name);
  const plane = planeOf(tree.restPose);
  const rest = tree.restPose.data;
  const step = Math.ceil(tree.pieceCount / 500);
  const some = Array.from({ length: Math.ceil(tree.pieceCount / step) }, (_, i) => i * step);
  const arcs = some.map((i) => fineArc(poseOf(rest, plane, i).curve));

  /** Does the piece continue the one that it hangs on? */
  const chained = (i: number): boolean => {
    const at = 4 * i;
    const v = tree.pieces.data[layerStart(tree.pieces, PIECE_LAYERS.ATTACH) + at + 1];
    const turn = layerStart(tree.pieces, PIECE_LAYERS.ORIENT) + at;
    return v === 1 && tree.pieces.data.subarray(turn, turn + 3).every((x) => x === 0);
  };

  test.each(MODELS.flatMap((model) => [1, 3].map((times) => [model, times] as const)))(
    'no piece stretches by 1e-4, none comes off, nothing is NaN: %s, %d times Beaufort 11',
    (model, times) => {
      const wind = galeOf(times * BEAUFORT_11, { model });
      const attach = layerStart(tree.pieces, PIECE_LAYERS.ATTACH);
      for (const pose of posesOf(tree, wind, GUSTS)) {
        expect(pose.every(Number.isFinite)).toBe(true);
        let stretch = 0;
        let apart = 0;
        let turned = 0;
        some.forEach((i, k) => {
          const { curve, o } = poseOf(pose, plane, i);
          // Of what is shorter than a hand, float32 knows no 1e-4 at a height of 20 m.
          if (arcs[k] > 0.1) stretch = Math.max(stretch, Math.abs(fineArc(curve) / arcs[k] - 1));
          const parent = tree.pieces.data[attach + 4 * i];
          if (!chained(i)) return;
          const above = poseOf(pose, plane, parent);
          apart = Math.max(apart, distance(above.curve.p3, curve.p0));
          const end = subtract(above.curve.p3, above.curve.p2);
          if (length(end) < 0.02 || arcs[k] < 0.1) return;
          turned = Math.max(turned, distance(unit(end), unit(subtract(curve.p1, curve.p0))));
          turned = Math.max(turned, distance(handlesOf(above.curve, above.o).t2, o));
        });
        expect(stretch).toBeLessThan(1e-4);
        expect(apart).toBeLessThan(1e-5);
        expect(turned).toBeLessThan(1e-3);
      }
    },
  );
});

describe('popping', () => {
  const tree = treeOf('quaking-aspen');
  const plane = planeOf(tree.restPose);

  test.each(MODELS)('tips move steadily through ten seconds at Beaufort 11: %s', (model) => {
    const wind = galeOf(BEAUFORT_11, { model });
    const frames = 600;
    const every = Math.ceil(tree.pieceCount / 60);
    const tips = Array.from({ length: Math.floor(tree.pieceCount / every) }, (_, i) => i * every);
    const end = POSE_TARGETS.P3 * plane;
    const at = new Float64Array(3 * tips.length);
    const velocity = new Float64Array(3 * tips.length);
    let jump = 0;
    let fastest = 0;
    let turn = 1;
    let frame = 0;
    const height = tree.bounds[5];
    const before = tips.map(() => [0, 0, 0]);
    for (const pose of posesOf(
      tree,
      wind,
      Array.from({ length: frames }, (_, i) => 2 + i / 60),
    )) {
      tips.forEach((tip, k) => {
        const { o } = poseOf(pose, plane, tip);
        if (frame > 0) turn = Math.min(turn, dot(o, before[k] as [number, number, number]));
        before[k] = [...o];
        for (let axis = 0; axis < 3; axis++) {
          const x = pose[end + 4 * tip + axis];
          const v = 60 * (x - at[3 * k + axis]);
          if (frame > 0) fastest = Math.max(fastest, Math.abs(v));
          if (frame > 1) jump = Math.max(jump, Math.abs(v - velocity[3 * k + axis]) / 60);
          at[3 * k + axis] = x;
          velocity[3 * k + axis] = v;
        }
      });
      frame++;
    }
    // A pop moves a tip in one frame by what it has not moved in the frames around it.
    expect(jump).toBeLessThan(0.006 * height);
    expect(fastest).toBeGreaterThan(0.02 * height);
    // And spins no bark: frames turn by less than 20 degrees a frame.
    expect(turn).toBeGreaterThan(Math.cos((20 * Math.PI) / 180));
  });
});
