/** What a swing that dies away says of itself. */
export interface Decay {
  /** Whole periods that were measured. */
  readonly swings: number;
  /** Seconds of one. */
  readonly period: number;
  /** Logarithm of the ratio of one deflection to that a period later. */
  readonly decrement: number;
}

/** An extremum of a sampled curve: when, in samples, and how high. */
interface Extremum {
  readonly at: number;
  readonly height: number;
}

/** The extremum of the parabola through three samples about i; the smallest error that three samples leave is of fourth order. */
function parabola(x: ArrayLike<number>, i: number): Extremum {
  const slope = (x[i + 1] - x[i - 1]) / 2;
  const bend = x[i + 1] - 2 * x[i] + x[i - 1];
  const off = bend === 0 ? 0 : -slope / bend;
  return { at: i + off, height: x[i] + (slope * off) / 2 };
}

/**
 * Period and decrement of a free decay about 0, sampled every `step` seconds, from its first to its last extremum that is clear of
 * rounding. It knows nothing of the oscillator's equation.
 */
export function freeDecay(x: ArrayLike<number>, step: number): Decay {
  const least = 1e-3 * Math.abs(x[0]);
  const extrema: Extremum[] = [];
  for (let i = 1; i + 1 < x.length; i++) {
    const turns = (x[i] - x[i - 1]) * (x[i + 1] - x[i]) <= 0;
    if (turns && Math.abs(x[i]) > least) extrema.push(parabola(x, i));
  }
  // An even number of half swings: a whole number of periods.
  const swings = Math.floor((extrema.length - 1) / 2);
  if (swings < 1) return { swings: 0, period: Number.NaN, decrement: Number.NaN };
  const [first, last] = [extrema[0], extrema[2 * swings]];
  return {
    swings,
    period: ((last.at - first.at) * step) / swings,
    decrement: Math.log(Math.abs(first.height / last.height)) / swings,
  };
}

/** The damping ratio of a decrement. */
export const dampingRatio = (decrement: number): number => decrement / Math.hypot(2 * Math.PI, decrement);
