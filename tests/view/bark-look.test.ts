import { expect, test } from 'vitest';
import { BARK_KINDS } from '../../src/core/species/species.ts';
import { barkDefines, deepShare } from '../../src/view/bark-look.ts';
import { gridDetail } from '../../src/view/detail.ts';
import { shippedSpecies } from '../core/pack/shipped-species.ts';

const species = shippedSpecies('quaking-aspen');
const bark = { ...species.bark, depth: 0.02, moss: 0.5 };

test('ridges cost nothing where they cannot be seen, and rise pixel by pixel where they can', () => {
  expect(deepShare(0, { ...bark, depth: 0 }, 400, 1000)).toBe(0);
  expect(deepShare(2, bark, 400, 1000)).toBe(0);
  expect(deepShare(0, bark, 20, 1000)).toBe(0);
  expect(deepShare(0, bark, 400, 10)).toBe(0);
  expect(deepShare(0, bark, 400, 1000)).toBe(1);
  let before = 0;
  for (let pixels = 40; pixels < 200; pixels++) {
    const share = deepShare(0, bark, pixels, 5 * pixels);
    expect(share).toBeGreaterThanOrEqual(before);
    expect(share - before).toBeLessThan(0.04);
    before = share;
  }
});

test('what grows on bark is in the programs of old stems that have some, and thin ones have none of it', () => {
  for (const kind of BARK_KINDS) {
    const look = { ...species, bark: { ...bark, kind } };
    expect(barkDefines(0, look, 'tube')).toContain('BARK_GROWTH');
    expect(barkDefines(1, look, 'ribbon')).toEqual([]);
    expect(barkDefines(3, look, 'tube').filter((name) => !/SPINED|BLOOM/.test(name))).toEqual(['JOINED']);
    const bare = { ...look, bark: { ...look.bark, moss: 0, lichen: 0 } };
    expect(barkDefines(0, bare, 'tube')).not.toContain('BARK_GROWTH');
  }
});

test('a relief has a grid of about square cells, and none finer than its triangles allow', () => {
  const { sectors, bands } = gridDetail(0, 120, 2, 'auto', 10, true);
  expect(sectors).toBeGreaterThan(gridDetail(0, 120, 2, 'auto').sectors);
  const square = (2 * Math.PI) / sectors / (10 / bands);
  expect(square).toBeGreaterThan(0.6);
  expect(square).toBeLessThan(1.6);
  expect(gridDetail(0, 120, 5000, 'auto', 10, true)).toEqual(gridDetail(0, 120, 5000, 'auto'));
});
