import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Mat3, Vec3 } from '../../../src/core/math/vec3.ts';
import {
  SPRING_RATE,
  type Spring,
  springStart,
  springStep,
  springStir,
  springTarget,
  springTransition,
  type Transition,
} from '../../../src/core/wind/spring.ts';
import { measuredResponse, springResponse } from '../../../src/core/wind/spring-response.ts';

const DT = 1 / SPRING_RATE;
const AXES: Mat3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Bend of a damped oscillator that starts at 1 and still, after `t` seconds: the closed form. */
function decay(omega: number, damping: number, t: number): number {
  const a = damping * omega;
  if (damping === 1) return Math.exp(-a * t) * (1 + a * t);
  if (damping > 1) {
    const w = omega * Math.sqrt(damping * damping - 1);
    const [quick, slow] = [-a - w, -a + w];
    return (quick * Math.exp(slow * t) - slow * Math.exp(quick * t)) / (quick - slow);
  }
  const w = omega * Math.sqrt(1 - damping * damping);
  return Math.exp(-a * t) * (Math.cos(w * t) + (a / w) * Math.sin(w * t));
}

/** Steps from 1 at rest without wind; what `see` is told is bend and velocity along T. */
function release(transition: Transition, steps: number, see: (q: number, v: number, step: number) => void): void {
  let spring: Spring = springStart([0, 1, 0], 0);
  for (let n = 1; n <= steps; n++) {
    spring = springStep(spring, [0, 0, 0], transition, AXES, [0, 0, 0], 1, 0);
    see(spring.q[0], spring.velocity[0], n);
  }
}

const anySpring = [
  fc.double({ min: Math.log(1e-3), max: Math.log(1e4), noNaN: true }).map(Math.exp),
  fc.double({ min: Math.log(1e-6), max: Math.log(1e3), noNaN: true }).map(Math.exp),
] as const;

describe('one step', () => {
  test.each([
    ['slow', 0.5, 0.12],
    ['fast', 12, 0.12],
    ['hardly damped', 5, 0.001],
    ['critical', 5, 1],
    ['nearly critical', 5, 1 + 1e-9],
    ['beyond critical', 5, 4],
    ['stiff, far beyond the step', 900, 0.3],
    ['stiff and beyond critical', 900, 20],
  ])('repeated follows the closed form: %s', (_, omega, damping) => {
    release(springTransition(omega, damping, DT), 600, (q, _v, n) => {
      expect(Math.abs(q - decay(omega, damping, n * DT))).toBeLessThan(1e-9);
    });
  });

  test('is the same whether taken at once or in parts', () => {
    fc.assert(
      fc.property(...anySpring, (omega, damping) => {
        const [a, b, c, d] = springTransition(omega, damping, DT);
        const [e, f, g, h] = springTransition(omega, damping, DT / 2);
        // (1 + B)^2 = 1 + 2 B + B^2
        const twice = [2 * e + e * e + f * g, 2 * f + e * f + f * h, 2 * g + g * e + h * g, 2 * h + g * f + h * h];
        const size = Math.max(1, omega);
        [a, b * size, c / size, d].forEach((x, i) => {
          expect(Math.abs(x - twice[i] * [1, size, 1 / size, 1][i])).toBeLessThan(1e-9);
        });
      }),
    );
  });

  test('no spring gains energy, for any frequency and damping', () => {
    fc.assert(
      fc.property(...anySpring, fc.double({ min: -1, max: 1, noNaN: true }), (omega, damping, share) => {
        const [b11, b12, b21, b22] = springTransition(omega, damping, DT);
        const [q, v] = [share, (1 - Math.abs(share)) * omega];
        const [x, y] = [q + b11 * q + b12 * v, v + b21 * q + b22 * v];
        const energy = (s: number, w: number): number => omega * omega * s * s + w * w;
        expect(energy(x, y)).toBeLessThanOrEqual(energy(q, v) * (1 + 1e-9));
      }),
    );
  });

  test.each([
    ['stiff', 600, 0.1],
    ['soft', 0.05, 0.1],
    ['hardly damped', 6, 1e-6],
    ['critical', 6, 1],
    ['beyond critical', 6, 50],
  ])('a million steps stay bounded, and the energy without wind never grows: %s', (_, omega, damping) => {
    // In single precision, as the GPU keeps it.
    const [b11, b12, b21, b22] = springTransition(omega, damping, DT).map(Math.fround);
    let q = 1;
    let v = 0;
    let least = omega * omega;
    let most = 0;
    for (let n = 0; n < 1e6; n++) {
      const x = q;
      q = Math.fround(x + Math.fround(b11 * x + b12 * v));
      v = Math.fround(v + Math.fround(b21 * x + b22 * v));
      const energy = omega * omega * q * q + v * v;
      most = Math.max(most, energy / least - 1);
      least = Math.min(least, energy + 1e-12 * omega * omega);
    }
    expect(Math.abs(q)).toBeLessThanOrEqual(1);
    // Single roundings may add a millionth of what there is; a thousandth would be a growth.
    expect(most).toBeLessThan(1e-3);
  });

  test('a million steps in a storm stay within what the closed form allows', () => {
    for (const [omega, damping] of [
      [0.5, 0.05],
      [12, 0.12],
      [300, 0.3],
      [6, 3],
    ]) {
      const transition = springTransition(omega, damping, DT);
      let spring = springStart([0, 0, 0], 0);
      let most = 0;
      for (let n = 0; n < 250_000; n++) {
        // Pushed as far as it goes whenever that speeds it up: nothing drives it harder.
        const target = spring.velocity[0] >= 0 ? 1 : -1;
        spring = springStep(spring, [0, target, 0], transition, AXES, [0, 0, 0], 1, 0);
        most = Math.max(most, Math.abs(spring.q[0]));
      }
      // Pumped at every swing: (1 + r)/(1 - r) with r the rest of a swing after half a turn; 1 where nothing swings.
      const r = damping < 1 ? Math.exp((-Math.PI * damping) / Math.sqrt(1 - damping * damping)) : 0;
      expect(most).toBeLessThan(1.02 * ((1 + r) / (1 - r)));
      expect(most).toBeGreaterThan(0.9);
    }
  });
});

describe('free decay', () => {
  test.each([
    [0.6, 0.03],
    [3, 0.12],
    [12, 0.2],
  ])('has frequency and damping of the closed form within 1 %% (omega %d, damping %d)', (omega, damping) => {
    const crossings: number[] = [];
    const peaks: number[] = [];
    let last: [number, number] = [1, 0];
    release(springTransition(omega, damping, DT), Math.ceil(60 * SPRING_RATE), (q, v, n) => {
      if (last[0] < 0 && q >= 0) crossings.push(n - q / (q - last[0]));
      // A crest lies where the velocity passes 0.
      if (last[1] > 0 && v <= 0) peaks.push(Math.max(q, last[0]));
      last = [q, v];
    });
    const swings = Math.min(crossings.length, peaks.length, 5) - 1;
    const measured = (2 * Math.PI * SPRING_RATE * swings) / (crossings[swings] - crossings[0]);
    expect(measured / (omega * Math.sqrt(1 - damping * damping))).toBeCloseTo(1, 2);
    const decrement = Math.log(peaks[0] / peaks[swings]) / swings;
    expect(decrement / Math.hypot(decrement, 2 * Math.PI) / damping).toBeCloseTo(1, 2);
  });
});

describe('resonance', () => {
  test.each([0.05, 0.12, 0.5])('a sweep meets the theory in amplitude and phase: damping %d', (damping) => {
    const omega = 2 * Math.PI * 0.8;
    for (const hertz of [0.1, 0.4, 0.7, 0.8, 0.9, 1.2, 2]) {
      const theory = springResponse(omega, damping, hertz);
      const measured = measuredResponse(omega, damping, hertz);
      expect(measured.amplitude / theory.amplitude).toBeCloseTo(1, 2);
      expect(Math.abs(measured.phase - theory.phase)).toBeLessThan(0.02);
    }
  });

  test('at its own frequency a spring answers 1/(2 damping) times, a quarter turn late', () => {
    const { amplitude, phase } = springResponse(5, 0.12, 5 / (2 * Math.PI));
    expect(amplitude).toBeCloseTo(1 / 0.24, 9);
    expect(phase).toBeCloseTo(-Math.PI / 2, 9);
  });
});

describe('the target', () => {
  const frame: Mat3 = [
    [0, 0, 1],
    [0, 1, 0],
    [-1, 0, 0],
  ];

  test('is the bend of the wind in the frame at rest', () => {
    expect(springTarget(frame, [0.3, 0.2, 0], [0, 0, 0], 1)).toEqual([0, 0.2, -0.3]);
  });

  test('lags behind when the base is pulled away, by at most 1', () => {
    const [along, t, s] = springTarget(frame, [0, 0, 0], [0, 4, 5], 0.1);
    expect([along, s]).toEqual([0, 0]);
    expect(t).toBeCloseTo(-0.4, 12);
    const wild = springTarget(frame, [0, 0, 0], [300, 400, 0], 0.1);
    expect(Math.hypot(wild[1], wild[2])).toBeCloseTo(1, 12);
  });
});

test('leaves are shaken by the wind and by the way of their branch', () => {
  const still = springStart([0, 0, 0], 0.2);
  const moving = { ...still, velocity: [3, 4] as [number, number] };
  expect(springStir(still, 0.5)).toBeCloseTo(0.2, 12);
  expect(springStir(moving, 0.5)).toBeCloseTo(0.2 + 0.25, 12);
});

test('a branch hands its acceleration on: the end of a piece moves as its bend says', () => {
  const reach = 2;
  const base: Vec3 = [1, 0, 0];
  const before = springStart([0, 0.5, 0], 0);
  const after = springStep(before, [0, 0, 0], springTransition(4, 0.1, DT), AXES, base, reach, 0);
  const acceleration = ((after.velocity[0] - before.velocity[0]) / DT) * reach;
  expect(after.end[0]).toBe(1);
  expect(after.end[1]).toBeCloseTo(acceleration, 9);
  // Let go, it first falls back with omega^2 times its bend.
  expect(after.end[1]).toBeCloseTo(-16 * 0.5 * reach, 0);
});
