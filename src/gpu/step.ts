/** Seconds of a step: the grid on which the states of the springs and of the lagged pose are functions of time. */
export const STEP = 1 / 60;

/** Part of a step that makes no difference: a time that was made of whole steps is one of them again. */
const WHOLE = 1e-4;

/** The two steps that a time lies between, and how far from the first to the second, 0 to below 1; 0 on a step, and before the first. */
export function stepsAt(time: number): { first: number; last: number; fraction: number } {
  const x = Math.max(0, time / STEP);
  const nearest = Math.round(x);
  if (Math.abs(x - nearest) < WHOLE) return { first: nearest, last: nearest, fraction: 0 };
  const first = Math.floor(x);
  return { first, last: first + 1, fraction: x - first };
}
