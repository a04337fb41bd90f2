import { expect, test } from 'vitest';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { mergeTrees } from '../../../src/core/pack/merge-trees.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { GroveMotion } from '../../../src/view/forest/grove-motion.ts';
import { GrovePace } from '../../../src/view/forest/grove-pace.ts';
import { GroveTrees } from '../../../src/view/forest/grove-trees.ts';
import { shippedSpecies } from '../../core/pack/shipped-species.ts';
import { shippedWind } from '../../core/wind/shipped-winds.ts';

/** Frames of sixty a second in which a grove is posed whose tips move so many pixels a second. */
function posed(pace: GrovePace, speed: number, frames: number, seen = true): number[] {
  const out: number[] = [];
  for (let frame = 1; frame <= frames; frame++) if (pace.due(frame, frame / 60, speed, seen, 1)) out.push(frame);
  return out;
}

test('what moves less on screen is posed in fewer frames, and groves take turns', () => {
  expect(posed(new GrovePace(0), 200, 24)).toHaveLength(24);
  const every = (own: number) => posed(new GrovePace(own), 7, 24).slice(1);
  expect(every(0)).toEqual([4, 8, 12, 16, 20, 24]);
  expect(every(1)).toEqual([3, 7, 11, 15, 19, 23]);
  expect(posed(new GrovePace(0), 0.1, 41).slice(1)).toEqual([8, 16, 24, 32, 40]);
  // Nobody sees it but by its shadow.
  expect(posed(new GrovePace(0), 200, 41, false).slice(1)).toEqual([8, 16, 24, 32, 40]);
});

test('a slow clock poses as often as the springs must be led on', () => {
  const pace = new GrovePace(0);
  let most = 0;
  for (let frame = 1, last = 0; frame < 200; frame++) {
    if (!pace.due(frame, frame / 8, 0.01, true, 1)) continue;
    if (frame > 100) most = Math.max(most, frame - last);
    last = frame;
  }
  expect(most / 8).toBeLessThanOrEqual(0.45);
});

test('a clock that stands is posed once, and again for another wind', () => {
  const pace = new GrovePace(3);
  expect(pace.due(1, 5, 0.1, true, 1)).toBe(true);
  expect([2, 3, 4].map((frame) => pace.due(frame, 5, 0.1, true, 1))).toEqual([false, false, false]);
  expect(pace.due(5, 5, 0.1, true, 2)).toBe(true);
  expect(pace.due(6, 1, 0.1, true, 2)).toBe(true);
});

const { packed } = growPacked(shippedSpecies('quaking-aspen'), 1, { quality: 0.2 });
const grove = mergeTrees([
  { tree: packed, x: 10, y: 0, z: 2, turn: 0 },
  { tree: packed, x: -10, y: 0, z: 0, turn: 1 },
]);

test('twigs are known to move faster in a gale than in a breeze', () => {
  const motion = new GroveMotion(grove);
  const speed = (name: string) => motion.speed(windStateAt(shippedWind(name), 3), 0.05);
  expect(speed('breeze')).toBeGreaterThan(0.1);
  expect(speed('breeze')).toBeLessThan(2);
  expect(speed('gale') / speed('breeze')).toBeGreaterThan(2);
});

test('the nearest tree counts, also from within the grove', () => {
  const trees = new GroveTrees(grove);
  const height = packed.bounds[5]!;
  const wide = 0.8 * Math.max(packed.crown[3]!, packed.crown[4]!);
  expect(trees.distance({ x: 40, y: 0, z: 5 } as never)).toBeCloseTo(30 - wide, 4);
  expect(trees.distance({ x: 0, y: 0, z: 1 } as never)).toBeCloseTo(10 - wide, 4);
  expect(trees.distance({ x: 10, y: 0, z: 4 } as never)).toBeCloseTo(0.1 * height, 4);
});
