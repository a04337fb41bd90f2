import { expect, it } from 'vitest';
import { Pace } from '../../../src/view/picture/pace.ts';

const run = (pace: Pace, frames: number, milliseconds: number): number => {
  for (let i = 0; i < frames; i++) pace.frame(milliseconds);
  return pace.scale;
};

it('leaves a machine that keeps up alone', () => {
  expect(run(new Pace(), 1000, 16.7)).toBe(1);
  expect(run(new Pace(), 1000, 33)).toBe(1);
});

it('draws fewer pixels where frames are slow, never fewer than half in each direction', () => {
  const pace = new Pace();
  expect(run(pace, 5, 400)).toBe(1);
  expect(pace.frame(400)).toBe(true);
  expect(pace.scale).toBeCloseTo(0.8);
  expect(run(pace, 100, 400)).toBe(0.5);
});

it('comes back when frames are quick again', () => {
  const pace = new Pace();
  run(pace, 100, 400);
  pace.restart();
  expect(run(pace, 2000, 16.7)).toBe(1);
});
