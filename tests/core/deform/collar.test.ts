import { expect, test } from 'vitest';
import { collar } from '../../../src/core/deform/collar.ts';

test('the collar is widest at the base, never wider than the parent, and ends smoothly three radii outside it', () => {
  expect(collar(0, 0.1, 0.4, 0.5)[0]).toBeCloseTo(1.5, 12);
  expect(0.1 * collar(0, 0.1, 0.12, 0.5)[0]).toBeCloseTo(0.12, 12);
  expect(collar(0.71, 0.1, 0.4, 0.5)).toEqual([1, 0]);
  const [factor, slope] = collar(0.7 - 1e-6, 0.1, 0.4, 0.5);
  expect(factor - 1).toBeLessThan(1e-9);
  expect(Math.abs(slope)).toBeLessThan(1e-5);
});

test('its slope is that of its factor', () => {
  for (const along of [0.01, 0.2, 0.5, 0.69]) {
    const h = 1e-6;
    const difference = (collar(along + h, 0.1, 0.4, 0.5)[0] - collar(along - h, 0.1, 0.4, 0.5)[0]) / (2 * h);
    expect(collar(along, 0.1, 0.4, 0.5)[1]).toBeCloseTo(difference, 6);
  }
});

test('a trunk and a stem thicker than its parent have none', () => {
  expect(collar(0.1, 0.1, 0, 0.5)).toEqual([1, 0]);
  expect(collar(0.1, 0.5, 0.4, 0.5)).toEqual([1, 0]);
});
