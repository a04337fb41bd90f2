import { expect, test } from 'vitest';
import { Turns } from '../../../src/editor/studio/turns.ts';

/** A clock that a drawing pushes on, and plots that cost what they are told to. */
function plots(costs: readonly number[], budget = 1.5) {
  const clock = { now: 0 };
  const drawn: number[] = costs.map(() => 0);
  const turns = new Turns(() => clock.now, budget);
  costs.forEach((cost, i) => {
    turns.add(() => {
      drawn[i]!++;
      clock.now += cost;
    });
  });
  const frame = (at: number): number => {
    clock.now = at;
    turns.askAll();
    return turns.run();
  };
  return { turns, drawn, frame, clock };
}

test('share a frame: after the first, none takes more than its share', () => {
  const { frame, drawn } = plots([0.6, 0.6, 0.6, 0.6, 0.6]);
  const spent = Array.from({ length: 300 }, (_, k) => frame((k * 1000) / 60));
  expect(Math.max(...spent.slice(10))).toBeLessThanOrEqual(1.5);
  // All come by, evenly.
  expect(Math.max(...drawn) - Math.min(...drawn)).toBeLessThanOrEqual(2);
  expect(Math.min(...drawn)).toBeGreaterThanOrEqual(100);
});

test('draw a plot no more often than its rate, and one that is too dear alone', () => {
  const { frame, drawn } = plots([0.1, 9]);
  for (let k = 0; k < 60; k++) frame((k * 1000) / 60);
  expect(drawn[0]).toBeLessThanOrEqual(31);
  expect(drawn[0]).toBeGreaterThan(15);
  expect(drawn[1]).toBeGreaterThan(0);
});

test('draw all at once where something changed, and nothing that did not ask', () => {
  const { turns, drawn, clock } = plots([5, 5, 5]);
  expect(turns.run(true)).toBe(0);
  turns.askAll();
  expect(turns.waiting).toBe(true);
  turns.run(true);
  expect(drawn).toEqual([1, 1, 1]);
  expect([turns.waiting, clock.now]).toEqual([false, 15]);
});

test('are over for what was taken away', () => {
  const turns = new Turns(() => 0);
  let drawn = 0;
  const turn = turns.add(() => drawn++);
  turn.ask();
  turn.remove();
  turns.run(true);
  expect([drawn, turns.waiting]).toEqual([0, false]);
});
