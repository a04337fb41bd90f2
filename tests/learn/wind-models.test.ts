import { describe, expect, test } from 'vitest';
import { measuredResponse, springResponse } from '../../src/core/wind/spring-response.ts';
import { smallTree } from '../../src/learn/ping-pong/small-tree.ts';
import { GUST_START, gustWind, traceOf } from '../../src/learn/wind-models/models.ts';
import {
  eulerStates,
  exactStates,
  overshootOf,
  overshootTheory,
  periodOf,
} from '../../src/learn/wind-models/oscillate.ts';
import { bareFrequency, printedFrequency, rodFrequency } from '../../src/learn/wind-models/rod.ts';
import { longLimb } from '../../src/learn/wind-models/three.ts';

const HERTZ = 2 * Math.PI;

describe('lesson: wind models', () => {
  test('the exact step overshoots and swings as theory says; explicit Euler goes farther', () => {
    const exact = exactStates([0, 0], 1, HERTZ * 0.8, 0.12, 600);
    expect(overshootTheory(0.12)).toBeCloseTo(0.684, 3);
    expect(overshootOf(exact, 1)).toBeCloseTo(overshootTheory(0.12), 3);
    expect(periodOf(exact, 1)).toBeCloseTo(1 / (0.8 * Math.sqrt(1 - 0.12 ** 2)), 2);
    // After the first swing of a limb of 1.5 Hz: the number of the table.
    expect(overshootOf(eulerStates([0, 0], 1, HERTZ * 1.5, 0.12, 61), 1).toFixed(2)).toBe('0.88');
    // A stiff branch: Euler gains energy without end, the exact step comes to rest.
    expect(overshootOf(eulerStates([0, 0], 1, HERTZ * 4, 0.12, 600), 1)).toBeGreaterThan(10);
    expect(exactStates([0, 0], 1, HERTZ * 4, 0.12, 600).at(-1)?.[0]).toBeCloseTo(1, 6);
  });

  test('at resonance the measured gain is 1/(2 zeta), a quarter turn late', () => {
    const measured = measuredResponse(HERTZ * 0.8, 0.12, 0.8);
    expect(measured.amplitude).toBeCloseTo(1 / 0.24, 1);
    expect(springResponse(HERTZ * 0.8, 0.12, 0.8).amplitude).toBeCloseTo(1 / 0.24, 9);
    expect((measured.phase * 180) / Math.PI).toBeCloseTo(-90, 0);
  });

  test('the printed sway of a trunk takes an hour and three quarters; a rod swings in seconds', () => {
    expect(1 / printedFrequency(13, 0.015 * 13)).toBeCloseTo(6283, 0);
    expect(rodFrequency(4, 0.03) / rodFrequency(8, 0.03)).toBeCloseTo(4, 9);
    expect(bareFrequency(13, 0.195)).toBeGreaterThan(0.2);
  });

  test('the same gust: direct has its shape, the spring comes later and swings on, sway does not hear it', () => {
    const { packed } = smallTree();
    const limb = longLimb(packed);
    const [direct, spring, sway, calm] = [
      gustWind('direct', 0.7, 0.6, 0.12),
      gustWind('spring', 0.7, 0.6, 0.12),
      gustWind('sway', 0.7, 0.6, 0.12),
      gustWind('sway', 0, 0.6, 0.12),
    ].map((wind) => traceOf(packed, limb, wind, 6).moved);
    const peak = (trace: Float64Array | undefined): number => trace?.indexOf(Math.max(...trace)) ?? 0;
    expect(peak(spring)).toBeGreaterThan(peak(direct) + 6);
    const after = Math.round(60 * (GUST_START + 2.5));
    const late = (trace: Float64Array | undefined): number => Math.max(...(trace?.slice(after) ?? []).map(Math.abs));
    expect(late(direct)).toBeLessThan(1e-6);
    expect(late(spring)).toBeGreaterThan(0.01);
    expect(sway).toEqual(calm);
  });
});
