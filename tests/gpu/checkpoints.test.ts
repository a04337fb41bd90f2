import fc from 'fast-check';
import { expect, test } from 'vitest';
import { Checkpoints, SPACING } from '../../src/gpu/checkpoints.ts';

/** Plays to `end`, keeping what is worth keeping. */
function played(end: number, capacity: number): Checkpoints {
  const checkpoints = new Checkpoints(capacity);
  for (let step = 1; step <= end; step++) checkpoints.keep(step, step);
  return checkpoints;
}

test('an hour fits: dense near what is shown, at most a third of the way back away from it anywhere', () => {
  const hour = 3600 * 60;
  const { steps } = played(hour, 48);
  expect(steps).toHaveLength(48);
  expect(steps).toEqual(steps.toSorted((a, b) => a - b));
  expect(steps.at(-1)).toBe(hour);
  expect(steps.at(-2)).toBe(hour - SPACING);
  for (let i = 1; i < steps.length; i++) {
    const [gap, back] = [steps[i]! - steps[i - 1]!, hour - steps[i - 1]!];
    expect(gap).toBeLessThanOrEqual(Math.max(4 * SPACING, 0.6 * back));
  }
});

test('a run towards a far step leaves as good checkpoints as playing there', () => {
  const checkpoints = new Checkpoints(16);
  let copies = 0;
  for (let step = 1; step <= 36_000; step++) if (checkpoints.keep(step, 36_000) !== null) copies++;
  expect(checkpoints.steps.at(-1)).toBe(36_000);
  expect(checkpoints.steps.at(-2)).toBeGreaterThanOrEqual(36_000 - 4 * SPACING);
  // What would be thinned out on the way is not copied at all.
  expect(copies).toBeLessThan(150);
});

test('every checkpoint has a place of its own, below the capacity, whatever is played, dropped and played again', () => {
  const doings = fc.array(fc.tuple(fc.boolean(), fc.integer({ min: 0, max: 1500 })), { minLength: 1, maxLength: 12 });
  fc.assert(
    fc.property(doings, (doing) => {
      const checkpoints = new Checkpoints(5);
      const places = new Map<number, number>();
      for (const [drops, step] of doing) {
        if (drops) checkpoints.dropAfter(step);
        for (let n = step; n < step + 200; n++) {
          const slot = checkpoints.keep(n, step + 200);
          if (slot !== null) places.set(slot, n);
        }
        for (const kept of checkpoints.steps) expect(places.get(checkpoints.before(kept)!.slot)).toBe(kept);
      }
      expect(Math.max(-1, ...places.keys())).toBeLessThan(5);
    }),
  );
});

test('the last checkpoint at or before a step is found', () => {
  const checkpoints = played(64, 8);
  expect(checkpoints.steps).toEqual([16, 32, 48, 64]);
  expect(checkpoints.before(15)).toBeNull();
  expect(checkpoints.before(47)?.step).toBe(32);
  expect(checkpoints.before(48)?.step).toBe(48);
  checkpoints.dropAfter(48);
  expect(checkpoints.steps).toEqual([16, 32, 48]);
  checkpoints.clear();
  expect(checkpoints.before(1000)).toBeNull();
});
