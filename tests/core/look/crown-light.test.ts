import { describe, expect, it } from 'vitest';
import { type CrownLight, crownLight, lightAt } from '../../../src/core/look/crown-light.ts';

/** Points evenly spread through a ball of a radius about (0, 0, 10). */
function ball(count: number, radius: number): Float32Array {
  const out = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const r = radius * Math.cbrt((i + 0.5) / count);
    const up = 2 * ((i * 0.7548776662) % 1) - 1;
    const turn = 2 * Math.PI * ((i * 0.5698402911) % 1);
    const wide = Math.sqrt(1 - up * up);
    out.set([r * wide * Math.cos(turn), r * wide * Math.sin(turn), 10 + r * up], 3 * i);
  }
  return out;
}

/** Light on the way from the centre along a direction, at parts of the radius. */
const along = (light: CrownLight, [x, y, z]: [number, number, number]): number[] =>
  [0, 0.3, 0.6, 0.9, 1.15].map((f) => lightAt(light, 4 * f * x, 4 * f * y, 10 + 4 * f * z));

describe('light inside a crown', () => {
  const points = ball(6000, 4);
  const light = crownLight(points, 0.02);

  it('is all there is outside and less the deeper inside, most towards the sky', () => {
    for (const way of [
      [0, 0, 1],
      [0.8, 0, 0.6],
      [-0.6, 0.6, 0.53],
    ] as [number, number, number][]) {
      const found = along(light, way);
      for (let i = 1; i < found.length; i++) expect(found[i]).toBeGreaterThan(found[i - 1]!);
    }
    expect(lightAt(light, 0, 0, 40)).toBeGreaterThan(0.95);
    expect(lightAt(light, 0, 0, 10)).toBeLessThan(0.7);
    expect(lightAt(light, 0, 0, 6.4)).toBeLessThan(lightAt(light, 0, 0, 13.6) - 0.1);
  });

  it('is the same all around a round crown', () => {
    const [a, b] = [lightAt(light, 3, 0, 10), lightAt(light, -2.1, 2.1, 10)];
    expect(Math.abs(a - b)).toBeLessThan(0.06);
  });

  it('lessens with the area of the leaves, and without them is 1 everywhere', () => {
    const thin = crownLight(points, 0.004);
    const centre = [thin, light, crownLight(points, 0.1)].map((l) => lightAt(l, 0, 0, 10));
    expect(centre[0]).toBeGreaterThan(centre[1]!);
    expect(centre[1]).toBeGreaterThan(centre[2]!);
    for (const none of [crownLight([], 1), crownLight(points, 0)]) {
      expect(none.data.every((value) => value === 255)).toBe(true);
      expect(lightAt(none, 1, 2, 3)).toBe(1);
    }
  });

  it('has no hard cells: neighbours differ little', () => {
    const n = light.cells;
    let most = 0;
    for (let i = 0; i + n * n < n ** 3; i++) most = Math.max(most, Math.abs(light.data[i + n * n]! - light.data[i]!));
    expect(most).toBeLessThan(60);
  });

  it('takes a tree of one leaf, and one flat as a sheet', () => {
    for (const few of [
      [1, 2, 3],
      [0, 0, 5, 1, 0, 5, 0, 1, 5, 1, 1, 5],
    ]) {
      const found = crownLight(few, 0.01);
      expect(found.size.every((size) => size > 0)).toBe(true);
      expect(found.data.every((value) => value > 30)).toBe(true);
    }
  });
});
