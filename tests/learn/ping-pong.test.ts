import { describe, expect, test } from 'vitest';
import { arcLength, type Cubic } from '../../src/core/math/bezier.ts';
import { distance, dot, type Vec3 } from '../../src/core/math/vec3.ts';
import { createWindState } from '../../src/core/wind/fade.ts';
import { poseTree } from '../../src/core/wind/pose-tree.ts';
import { STEP } from '../../src/gpu/step.ts';
import { errorsOf, impulse } from '../../src/learn/ping-pong/chain.ts';
import { apartByDepth, bothPoses } from '../../src/learn/ping-pong/lag-run.ts';
import { swell } from '../../src/learn/ping-pong/lagged.ts';
import { poseIn } from '../../src/learn/ping-pong/live-pose.ts';
import { attachAxes, leanOf, printedAxis } from '../../src/learn/ping-pong/printed-axis.ts';
import { bentBranch, uprightBranch } from '../../src/learn/ping-pong/printed-step.ts';
import { smallTree } from '../../src/learn/ping-pong/small-tree.ts';
import { StruckWind } from '../../src/learn/ping-pong/struck-wind.ts';
import { twinPose } from '../../src/learn/ping-pong/twin-pose.ts';

const PARENT: Cubic = { p0: [0, 0, 0], p1: [0, 0, 0.75], p2: [0.33, 0, 1.4], p3: [1.5, 0, 1.5] };
const O: Vec3 = [1, 0, 0];

describe('lesson: ping-pong', () => {
  test('equation 17 as printed makes edges of a metre without any wind; ours gives the branch back', () => {
    const rest = uprightBranch(1, 0);
    expect(arcLength(bentBranch(rest, [0, 0, 0], 'printed')).toFixed(2)).toBe('2.33');
    for (const form of ['units', 'ours'] as const)
      expect(distance(bentBranch(rest, [0, 0, 0], form).p3, rest.p3)).toBeLessThan(1e-9);
  });

  test('with its units repaired it stretches in the wind; ours keeps its length', () => {
    const rest = uprightBranch(1, 0);
    expect(arcLength(bentBranch(rest, [1, 0, 0], 'units')).toFixed(2)).toBe('1.10');
    for (const b of [0.3, 1, 3]) expect(arcLength(bentBranch(rest, [b, 0, 0], 'ours'))).toBeCloseTo(arcLength(rest), 9);
  });

  test('the printed axis V leans, ours stands upright on the curve', () => {
    let most = 0;
    for (const v of [0.2, 0.5, 0.8])
      for (const theta of [0, 1, 2, 3]) {
        const [u, across, w] = attachAxes(PARENT, O, v, theta);
        expect(Math.abs(dot(u, across)) + Math.abs(dot(u, w))).toBeLessThan(1e-12);
        most = Math.max(most, Math.abs(leanOf(printedAxis(PARENT, O, v, theta), u)));
      }
    expect(most).toBeGreaterThan(3);
  });

  test('an impulse takes d steps to level d, and depth by depth none', () => {
    const run = impulse(5, 0.8, 6);
    run.steps.forEach((pose, step) => {
      errorsOf(run, pose).forEach((error, level) => {
        if (level <= step) expect(error).toBeLessThan(1e-6);
        else expect(error).toBeGreaterThan(0.05);
      });
    });
    expect(Math.max(...errorsOf(run, run.exact))).toBe(0);
  });

  test('in a swell the lagged tree is off by less than depth times step times speed, more with each depth', () => {
    const { packed } = smallTree();
    const wind = swell(0.8, 0.5);
    const rate = 20;
    const most = [0, 0, 0, 0];
    const fastest = [0, 0, 0, 0];
    for (let step = 0; step < 40; step++) {
      const { exact, lagged } = bothPoses(packed, wind, step, rate);
      const before = bothPoses(packed, wind, step - 1, rate).exact;
      apartByDepth(packed, exact, lagged).forEach((e, d) => {
        most[d] = Math.max(most[d] ?? 0, e);
      });
      apartByDepth(packed, exact, before).forEach((e, d) => {
        fastest[d] = Math.max(fastest[d] ?? 0, e * rate);
      });
    }
    expect(most[0]).toBe(0);
    expect(most[1] ?? 0).toBeGreaterThan(0.005);
    expect(most[3] ?? 0).toBeGreaterThan(2 * (most[1] ?? 0));
    for (const d of [1, 2, 3]) expect(most[d] ?? 0).toBeLessThan((d / rate) * (fastest[d] ?? 0));
  });

  test('the stored rotations give the rest pose back', () => {
    const { packed } = smallTree();
    const still = poseTree(packed, createWindState(), 'exact');
    expect(Math.max(...apartByDepth(packed, still, packed.restPose.data))).toBeLessThan(1e-6);
  });

  test('without float targets the twin fills the same two sets: in turn and a depth a step late, or by parity and never late', async () => {
    const { packed } = smallTree();
    const wind = new StruckWind(packed.depthStart.length);
    wind.struck = true;
    const source = twinPose(packed);
    for (const way of ['lagged', 'exact'] as const) {
      wind.pose = way;
      for (let step = 0; step < 2 * wind.turn; step++) {
        const two = await source.run(step * STEP, wind);
        const apart = apartByDepth(packed, poseIn(packed, two!), poseTree(packed, wind.at(step * STEP), 'exact'));
        const since = way === 'exact' ? apart.length : step % wind.turn;
        expect(apart.map((metres) => metres > 1e-6)).toEqual(apart.map((_, depth) => depth > since));
        expect(two?.written).toBe(way === 'exact' ? null : step & 1);
      }
    }
  });
});
