import type { ProbeHistory } from './probe-history.ts';
import { PROBE_RATE } from './probe-history.ts';
import { dominantFrequency, spectrumOf } from './spectrum.ts';
import { speedOfForce } from './speed.ts';

/** What a stretch of a probe's history comes to. Metres, metres a second, hertz. */
export interface ProbeSummary {
  /** Seconds that it covers. */
  readonly seconds: number;
  /** Of the wind that the force is of. */
  readonly wind: { readonly mean: number; readonly greatest: number };
  /** Of the end from its rest, along the wind, and how far from rest it got at most in any direction. */
  readonly displacement: { readonly mean: number; readonly greatest: number };
  /** Root of the mean square of the end's velocity along the wind, and the greatest. */
  readonly velocity: { readonly rms: number; readonly greatest: number };
  /** Dominant frequency of the wind, and of the displacement along the wind; null: none. */
  readonly frequency: { readonly wind: number | null; readonly displacement: number | null };
}

const mean = (values: Float64Array): number =>
  values.length > 0 ? values.reduce((sum, v) => sum + v, 0) / values.length : 0;
const greatest = (values: Float64Array): number => values.reduce((most, v) => Math.max(most, Math.abs(v)), 0);

/** Root of the mean square; 0 of nothing. */
export const rootMeanSquare = (values: Float64Array): number =>
  values.length > 0 ? Math.sqrt(values.reduce((sum, v) => sum + v * v, 0) / values.length) : 0;

/** Sums up the last `steps` readings; `axis` as in ProbeHistory.column. null where there are too few to say anything. */
export function summarize(history: ProbeHistory, axis: number, steps = history.count): ProbeSummary | null {
  const n = Math.min(steps, history.count);
  if (n < 16) return null;
  const wind = history.column('force', axis, n).map(speedOfForce);
  const along = history.column('along', axis, n);
  const across = history.column('across', axis, n);
  const up = history.column('up', axis, n);
  const velocity = history.column('velocityAlong', axis, n);
  return {
    seconds: n / PROBE_RATE,
    wind: { mean: mean(wind), greatest: greatest(wind) },
    displacement: { mean: mean(along), greatest: greatest(along.map((x, i) => Math.hypot(x, across[i], up[i]))) },
    velocity: { rms: rootMeanSquare(velocity), greatest: greatest(velocity) },
    frequency: {
      wind: dominantFrequency(spectrumOf(wind, PROBE_RATE)),
      displacement: dominantFrequency(spectrumOf(along, PROBE_RATE)),
    },
  };
}
