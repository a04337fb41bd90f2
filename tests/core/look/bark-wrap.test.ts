import { describe, expect, it } from 'vitest';
import { stemRadius } from '../../../src/core/deform/radius.ts';
import { barkWrap, type WrappedStem, wrapPoint } from '../../../src/core/look/bark-wrap.ts';
import { BARK_KINDS } from '../../../src/core/species/species.ts';

const shape = { taper: 1, flare: 0.8, lobes: 0, lobeDepth: 0, lobeFade: 0, bulges: 0, bulgeDepth: 0 };
const trunk: WrappedStem = { shape, level: 0, baseRadius: 0.3, length: 12, phase: 0.37 };

describe('how bark is laid around a stem', () => {
  it.each(BARK_KINDS)('%s closes: both sides of the seam have the same place of the tile', (kind) => {
    const wrap = barkWrap({ kind, grain: 0.13 });
    const [u0, v0] = wrapPoint(wrap, trunk, 0, 0.4);
    const [u1, v1] = wrapPoint(wrap, trunk, 1, 0.4);
    expect(u1 - u0).toBeCloseTo(Math.round(u1 - u0), 12);
    expect(v1).toBe(v0);
  });

  it('keeps the proportions of its pattern on a flared foot and on the thin end of a trunk', () => {
    const wrap = barkWrap({ kind: 'furrowed', grain: 0.13 });
    const [first] = wrapPoint(wrap, trunk, 0, 0);
    const around = wrapPoint(wrap, trunk, 1, 0)[0] - first;
    for (const z of [0, 0.01, 0.04, 0.1, 0.3, 0.5, 0.7]) {
      const [radius] = stemRadius(shape, trunk.baseRadius, trunk.length, z, 0);
      const tileAround = (2 * Math.PI * radius) / around;
      const step = 1e-4;
      const tileAlong =
        (step * trunk.length) / (wrapPoint(wrap, trunk, 0, z + step)[1] - wrapPoint(wrap, trunk, 0, z)[1]);
      expect(tileAround / tileAlong, `at ${z}`).toBeGreaterThan(0.9);
      expect(tileAround / tileAlong, `at ${z}`).toBeLessThan(1.1);
    }
  });

  it('never lets it run away at a tip', () => {
    const wrap = barkWrap({ kind: 'plated', grain: 0.1 });
    const [, v] = wrapPoint(wrap, trunk, 0, 1);
    expect(v - wrapPoint(wrap, trunk, 0, 0)[1]).toBeLessThan((5 * trunk.length) / wrap.side);
  });

  it('keeps the joints of a cane and the rings of a palm at their distance, however thin the stem', () => {
    for (const kind of ['noded', 'palm', 'ribbed'] as const) {
      const wrap = barkWrap({ kind, grain: 0.3 });
      for (const baseRadius of [0.3, 0.02]) {
        const thin = { ...trunk, baseRadius };
        for (const z of [0, 0.6]) {
          const tiles = wrapPoint(wrap, thin, 0, z + 0.1)[1] - wrapPoint(wrap, thin, 0, z)[1];
          expect(tiles * wrap.side).toBeCloseTo(0.1 * trunk.length, 9);
        }
      }
    }
  });

  it('puts the areoles of a cactus on the crests of its ribs', () => {
    const wrap = barkWrap({ kind: 'ribbed', grain: 0.03 });
    const ribbed = { ...trunk, shape: { ...shape, flare: 0, lobes: 13, lobeDepth: 0.1 } };
    for (let rib = 0; rib < 13; rib++) {
      const crest = (rib + 0.25) / 13;
      const [here] = stemRadius(ribbed.shape, 0.3, 12, 0.2, crest);
      expect(here).toBeGreaterThan(stemRadius(ribbed.shape, 0.3, 12, 0.2, crest + 0.01)[0]);
      const strips = wrapPoint(wrap, ribbed, crest, 0.2)[0] * wrap.ribs;
      expect(strips - Math.floor(strips)).toBeCloseTo(0.5, 9);
    }
  });
});
