import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createProfileUniforms, fillProfile, profileFactor } from '../../../src/core/wind/profile.ts';
import type { HeightProfile } from '../../../src/core/wind/wind.ts';

const LOG: HeightProfile = { kind: 'log', height: 10, roughness: 0.5, exponent: 0.2 };
const POWER: HeightProfile = { ...LOG, kind: 'power', exponent: 0.25 };
const NONE: HeightProfile = { ...LOG, kind: 'none' };

function factor(z: number, to: HeightProfile, from = to, h = 1): number {
  const out = createProfileUniforms();
  fillProfile(out, to, from, h);
  return out.profiled === 1 ? profileFactor(out, z) : 1;
}

const real = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const anyProfile: fc.Arbitrary<HeightProfile> = fc.record({
  kind: fc.constantFrom('none' as const, 'log' as const, 'power' as const),
  height: real(0.5, 50),
  roughness: real(0.0001, 2),
  exponent: real(0, 1),
});

describe('height profile', () => {
  test('is off by default', () => {
    const out = createProfileUniforms();
    fillProfile(out, NONE);
    expect(out.profiled).toBe(0);
  });

  test('is 1 at its height, whatever the law', () => {
    expect(factor(8, { ...LOG, height: 8 })).toBe(1);
    expect(factor(8, { ...POWER, height: 8 })).toBe(1);
    fc.assert(
      fc.property(anyProfile, (profile) => {
        expect(factor(profile.height, profile)).toBeCloseTo(1, 6);
      }),
    );
  });

  test('the logarithm of the height over the roughness, nothing within it, at the ground or below', () => {
    for (const z of [0.6, 2, 5, 30]) expect(factor(z, LOG)).toBeCloseTo(Math.log(z / 0.5) / Math.log(20), 6);
    for (const z of [0.5, 0.1, 1e-9, 0, -0, -3, -1e9]) expect(factor(z, LOG)).toBeCloseTo(0, 6);
    for (const z of [0.4, 0, -3]) expect(factor(z, LOG)).toBe(0);
  });

  test('a power of the height, as good as nothing at the ground', () => {
    for (const z of [0.1, 2, 30]) expect(factor(z, POWER)).toBeCloseTo((z / 10) ** 0.25, 6);
    for (const z of [0, -3]) expect(factor(z, POWER)).toBeLessThan(2e-3);
  });

  test('is a number and never negative, and grows with height', () => {
    fc.assert(
      fc.property(anyProfile, anyProfile, real(0, 1), (from, to, h) => {
        let last = 0;
        for (const z of [-5, 0, 1e-6, 0.01, 0.5, 1, 5, 10, 40]) {
          const f = factor(z, to, from, h);
          expect(f).toBeGreaterThanOrEqual(last - 1e-6);
          expect(Number.isFinite(f)).toBe(true);
          last = f;
        }
      }),
      { numRuns: 500 },
    );
  });

  test('fades from any to any other: begins in the one, ends in the other, without a jump', () => {
    fc.assert(
      fc.property(anyProfile, anyProfile, fc.constantFrom(-1, 0, 0.3, 2, 9, 25), (from, to, z) => {
        expect(factor(z, to, from, 0)).toBeCloseTo(factor(z, from), 4);
        expect(factor(z, to, from, 1)).toBeCloseTo(factor(z, to), 6);
        const n = 2000;
        let last = factor(z, to, from, 0);
        let jump = 0;
        for (let i = 1; i <= n; i++) {
          const f = factor(z, to, from, i / n);
          jump = Math.max(jump, Math.abs(f - last) / Math.max(1, f, last));
          last = f;
        }
        expect(jump).toBeLessThan(0.04);
      }),
      { numRuns: 60 },
    );
  });
});
