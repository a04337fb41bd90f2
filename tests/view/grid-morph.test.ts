import { expect, test } from 'vitest';
import { gridDetail } from '../../src/view/detail.ts';
import { branchGrid } from '../../src/view/grid.ts';
import { chordRadius, morphTo, nextGrid } from '../../src/view/grid-morph.ts';

const gridAt = (radius: number) => gridDetail(1, radius, 30, 'auto');

test('a grid has become the next where the next takes its place, and is itself well above', () => {
  for (const radius of [200, 40, 10, 2]) {
    const next = nextGrid(radius, gridAt);
    if (!next) throw new Error(`nothing follows at ${radius}`);
    expect(gridAt(next.at * 1.0001)).toEqual(gridAt(radius));
    expect(gridAt(next.at * 0.9999)).toEqual({ sectors: next.sectors, bands: next.bands });
    expect(morphTo(next, next.at)).toBe(1);
    expect(morphTo(next, next.at * 1.5)).toBe(0);
    expect(morphTo(next, next.at * 1.25)).toBeCloseTo(0.5, 9);
  }
  expect(nextGrid(0.001, gridAt)).toBeNull();
});

test('its columns then stand on the flat sides of the coarser polygon', () => {
  const { position, shape } = branchGrid({ sectors: 12, bands: 1, cap: false, bundle: 1, coarse: 8 });
  for (let vertex = 0; vertex < 13; vertex++) {
    const [x, y] = [0, 1].map((k) => position[3 * vertex + k]! * shape[3 * vertex + 2]!) as [number, number];
    // The side that the vertex is on: its distance from the axis, measured along the side's own normal.
    const side = (Math.floor((vertex / 12) * 8 + 1e-9) + 0.5) / 8;
    const away = x * Math.cos(2 * Math.PI * side) + y * Math.sin(2 * Math.PI * side);
    expect(away).toBeCloseTo(Math.cos(Math.PI / 8), 6);
  }
  expect(chordRadius(0.25, 8)).toBeCloseTo(1, 12);
  expect(chordRadius(1 / 16, 8)).toBeCloseTo(Math.cos(Math.PI / 8), 12);
});
