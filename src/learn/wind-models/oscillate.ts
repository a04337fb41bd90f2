import type { Mat3 } from '../../core/math/vec3.ts';
import { SPRING_RATE, springStep, springTransition } from '../../core/wind/spring.ts';

const AXES: Mat3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Where a branch is, and how fast it goes. */
export type State = readonly [q: number, velocity: number];

/** The states of a spring that strives for `target`, one a step of 1/60 s, by the step of the wind pass. */
export function exactStates(start: State, target: number, omega: number, damping: number, count: number): State[] {
  const transition = springTransition(omega, damping, 1 / SPRING_RATE);
  const states: State[] = [start];
  for (let n = 1; n < count; n++) {
    const [q, velocity] = states[n - 1] ?? start;
    const next = springStep({ q: [q, 0], velocity: [velocity, 0] }, [0, target, 0], transition, AXES, [0, 0, 0], 1, 0);
    states.push([next.q[0], next.velocity[0]]);
  }
  return states;
}

/** The same by explicit Euler: what one would write first, and what gains energy with every step. For teaching. */
export function eulerStates(start: State, target: number, omega: number, damping: number, count: number): State[] {
  const dt = 1 / SPRING_RATE;
  const states: State[] = [start];
  for (let n = 1; n < count; n++) {
    const [q, velocity] = states[n - 1] ?? start;
    states.push([q + velocity * dt, velocity + (omega * omega * (target - q) - 2 * damping * omega * velocity) * dt]);
  }
  return states;
}

/** How far beyond the target a run goes that began at rest at 0, as a part of the target. */
export const overshootOf = (states: readonly State[], target: number): number =>
  Math.max(0, states.reduce((most, [q]) => Math.max(most, q), Number.NEGATIVE_INFINITY) / target - 1);

/** The same by theory: e^(-pi zeta/sqrt(1 - zeta^2)), nothing from critical damping on. */
export const overshootTheory = (damping: number): number =>
  damping < 1 ? Math.exp((-Math.PI * damping) / Math.sqrt(1 - damping * damping)) : 0;

/** Seconds of a swing of a run: between the first and the third time that it crosses the target; NaN where it does not. */
export function periodOf(states: readonly State[], target: number): number {
  const crossings: number[] = [];
  for (let n = 1; n < states.length && crossings.length < 3; n++) {
    const [a, b] = [(states[n - 1]?.[0] ?? 0) - target, (states[n]?.[0] ?? 0) - target];
    if (a * b < 0) crossings.push((n - 1 + a / (a - b)) / SPRING_RATE);
  }
  return crossings.length === 3 ? (crossings[2] ?? 0) - (crossings[0] ?? 0) : Number.NaN;
}
