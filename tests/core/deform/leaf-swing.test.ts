import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { leafSwing, leanTowards, turnAlong } from '../../../src/core/deform/leaf-swing.ts';
import { cross, dot, length, unit, type Vec3 } from '../../../src/core/math/vec3.ts';

const part = fc.double({ min: 0, max: 1, noNaN: true });
const stir = fc.double({ min: 0, max: 1.5, noNaN: true });
const pliant = fc.double({ min: 0, max: 1, noNaN: true });
const vector = fc
  .tuple(...[0, 1, 2].map(() => fc.double({ min: -1, max: 1, noNaN: true })))
  .filter(([x, y, z]) => Math.hypot(x!, y!, z!) > 0.1)
  .map(([x, y, z]): Vec3 => [x!, y!, z!]);

describe('leaf swing', () => {
  it('leaves a leaf at rest in still air, and one that is not pliant in any', () => {
    fc.assert(
      fc.property(stir, part, part, pliant, part, (force, own, phase, soft, beats) => {
        for (const still of [leafSwing(0, own, phase, soft, beats), leafSwing(force, own, phase, 0, beats)]) {
          expect(Math.hypot(...still.sines, still.lean)).toBeLessThan(1e-12);
        }
      }),
    );
  });

  it('never turns a leaf beyond a right angle, whatever blows', () => {
    fc.assert(
      fc.property(stir, part, part, pliant, part, (force, own, phase, soft, beats) => {
        const { sines, lean } = leafSwing(force, own, phase, soft, beats);
        for (const sine of sines) expect(Math.abs(sine)).toBeLessThanOrEqual(0.95);
        expect(lean).toBeGreaterThanOrEqual(0);
        expect(Number.isFinite(lean)).toBe(true);
      }),
    );
  });

  it('turns about the foot of the stalk and stretches nothing', () => {
    fc.assert(
      fc.property(
        vector,
        vector,
        vector,
        part,
        fc.double({ min: 0, max: 5, noNaN: true }),
        (axis, p, w, calm, lean) => {
          const d = unit(axis);
          const level = Math.hypot(w[0], w[1]) || 1;
          const e = leanTowards(d, [(calm * w[0]) / level, (calm * w[1]) / level], lean);
          expect(length(e)).toBeCloseTo(1, 10);
          expect(turnAlong([0, 0, 0], d, e)).toEqual([0, 0, 0]);
          const [turned, other] = [turnAlong(p, d, e), turnAlong(w, d, e)];
          expect(length(turned)).toBeCloseTo(length(p), 9);
          expect(dot(turned, other)).toBeCloseTo(dot(p, w), 9);
          // What lay along the leaf still does.
          expect(length(cross(turnAlong(d, d, e), e))).toBeLessThan(1e-9);
        },
      ),
    );
  });

  it('leans downwind, more in stronger wind, and does not turn a leaf over that points into it', () => {
    const lean = (force: number) => leafSwing(force, 0.5, 0.5, 0.4, 0.25).lean;
    expect(lean(0.4)).toBeGreaterThan(1.8 * lean(0.1));
    const across = leanTowards([0, 1, 0], [1, 0], lean(0.6));
    expect(across[0]).toBeGreaterThan(0.6);
    expect(leanTowards([-1, 0, 0], [1, 0], 5)).toEqual([-1, 0, 0]);
  });

  it('beats a whole number of times in sixteen beats, so that time may wrap', () => {
    fc.assert(
      fc.property(stir, part, part, pliant, (force, own, phase, soft) => {
        const [start, end] = [0, 1].map((beats) => leafSwing(force, own, phase, soft, beats));
        expect(end!.sines[0]).toBeCloseTo(start!.sines[0], 6);
        expect(end!.sines[1]).toBeCloseTo(start!.sines[1], 6);
      }),
    );
  });

  it('never beats in unison: neighbours are no more together than chance has it', () => {
    const leaves = Array.from({ length: 400 }, (_, i) => [(i * 0.618034) % 1, (i * 0.754878) % 1] as const);
    for (const force of [0.05, 0.3, 0.7]) {
      for (const beats of [0.1, 0.37, 0.81]) {
        const rolls = leaves.map(([own, phase]) => leafSwing(force, own, phase, 0.4, beats).sines[0]);
        const mean = rolls.reduce((a, b) => a + b) / rolls.length;
        const spread = Math.sqrt(rolls.reduce((a, b) => a + (b - mean) ** 2, 0) / rolls.length);
        expect(Math.abs(mean)).toBeLessThan(0.25 * spread);
      }
    }
  });

  it('streams in a storm rather than turning to and fro: it rolls less widely than in a strong breeze, and leans more', () => {
    const width = (force: number) => {
      let most = 0;
      for (let k = 0; k < 200; k++) most = Math.max(most, Math.abs(leafSwing(force, 0.4, 0.3, 0.4, k / 200).sines[0]));
      return most;
    };
    expect(width(0.8)).toBeLessThan(width(0.15));
    expect(leafSwing(0.8, 0.4, 0.3, 0.4, 0.1).lean).toBeGreaterThan(2 * leafSwing(0.15, 0.4, 0.3, 0.4, 0.1).lean);
  });
});
