import { SPRING_RATE, springStart, springStep, springTransition } from './spring.ts';

/** How a spring answers a target that swings by 1: amplitude, and phase in radians (negative: it lags). */
export interface Response {
  amplitude: number;
  phase: number;
}

/**
 * The answer of a spring to a steady sine of `hertz`, by theory: 1/(1 - r^2 + 2 i damping r) with r the ratio of the frequencies.
 * `omega` in rad/s. Source: the damped oscillator's transfer function.
 */
export function springResponse(omega: number, damping: number, hertz: number): Response {
  const r = (2 * Math.PI * hertz) / omega;
  const real = 1 - r * r;
  const imaginary = 2 * damping * r;
  return { amplitude: 1 / Math.sqrt(real * real + imaginary * imaginary), phase: -Math.atan2(imaginary, real) };
}

/** The sine of `hertz` in samples at equal steps, least squares: from its amplitude 1 and phase 0 how far. */
export function sineIn(samples: ArrayLike<number>, seconds: (sample: number) => number, hertz: number): Response {
  let ss = 0;
  let sc = 0;
  let cc = 0;
  let sy = 0;
  let cy = 0;
  for (let i = 0; i < samples.length; i++) {
    const angle = 2 * Math.PI * hertz * seconds(i);
    const sin = Math.sin(angle);
    const cos = Math.cos(angle);
    ss += sin * sin;
    sc += sin * cos;
    cc += cos * cos;
    sy += sin * samples[i];
    cy += cos * samples[i];
  }
  const det = ss * cc - sc * sc;
  const a = (sy * cc - cy * sc) / det;
  const b = (cy * ss - sy * sc) / det;
  return { amplitude: Math.sqrt(a * a + b * b), phase: Math.atan2(b, a) };
}

/**
 * The same, measured: the steps of the wind pass in a wind whose bend is a sine, once its beginning has died away. What differs from
 * the theory is the sampling, within 1 % up to 2 Hz.
 */
export function measuredResponse(omega: number, damping: number, hertz: number): Response {
  const transition = springTransition(omega, damping, 1 / SPRING_RATE);
  const settled = Math.ceil((SPRING_RATE * 12) / (Math.min(damping, 1 / damping) * omega));
  const watched = Math.ceil((SPRING_RATE * 8) / hertz);
  const samples = new Float64Array(watched);
  let spring = springStart([0, 0, 0], 0);
  for (let n = 0; n < settled + watched; n++) {
    // The wind of the middle of the step, as the pass takes it.
    const target = Math.sin((2 * Math.PI * hertz * (n + 0.5)) / SPRING_RATE);
    spring = springStep(spring, [0, target, 0], transition, AXES, [0, 0, 0], 1, 0);
    if (n >= settled) samples[n - settled] = spring.q[0];
  }
  return sineIn(samples, (i) => (settled + i + 1) / SPRING_RATE, hertz);
}

const AXES: [[number, number, number], [number, number, number], [number, number, number]] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
