import { PROBE_RATE, type ProbeHistory } from '../../core/wind/probe-history.ts';
import { spectrumOf } from '../../core/wind/spectrum.ts';
import { speedOfForce, speedPerForce } from '../../core/wind/speed.ts';

/** Force, displacement and velocity over time: what the three plots over time and the phase portrait draw, and the file holds. */
export interface TimeData {
  /** Seconds. */
  readonly time: Float64Array;
  /** Force at the probe as the speed of the wind that it is, metres a second: its size, and its part across the wind. */
  readonly force: Float64Array;
  readonly forceAcross: Float64Array;
  /** Displacement of the branch's end from its rest, metres, along and across the wind, and upwards. */
  readonly along: Float64Array;
  readonly across: Float64Array;
  readonly up: Float64Array;
  /** Its velocity, metres a second. */
  readonly velocityAlong: Float64Array;
  readonly velocityAcross: Float64Array;
}

/** The spectra of force and displacement. */
export interface SpectrumData {
  /** Hertz. */
  readonly frequency: Float64Array;
  /** Power densities, (m/s)^2/Hz and m^2/Hz. */
  readonly force: Float64Array;
  readonly displacement: Float64Array;
}

/** What of the wind is across it, metres a second, by the size of the force and what of that is across. */
const speedAcross = (force: Float64Array, across: Float64Array): Float64Array =>
  across.map((part, i) => part * speedPerForce(force[i]!));

/** The last `seconds` of a history; `axis`: the direction that `along` means, radians. */
export function timeData(history: ProbeHistory, axis: number, seconds: number): TimeData {
  const steps = seconds * PROBE_RATE + 1;
  const column = (name: Parameters<ProbeHistory['column']>[0]): Float64Array => history.column(name, axis, steps);
  const force = column('force');
  return {
    time: column('time'),
    force: force.map(speedOfForce),
    forceAcross: speedAcross(force, column('forceAcross')),
    along: column('along'),
    across: column('across'),
    up: column('up'),
    velocityAlong: column('velocityAlong'),
    velocityAcross: column('velocityAcross'),
  };
}

/** Spectra of all that a history holds: the longer, the finer. */
export function spectrumData(history: ProbeHistory, axis: number): SpectrumData {
  const force = spectrumOf(history.column('force', axis).map(speedOfForce), PROBE_RATE);
  const along = spectrumOf(history.column('along', axis), PROBE_RATE);
  return { frequency: force.frequency, force: force.power, displacement: along.power };
}

/** A spectrum in decibels below its own peak, none below `floor`: two with different units share an axis. */
export function decibels(power: Float64Array, floor: number): Float64Array {
  const peak = power.reduce((most, p, k) => (k > 0 ? Math.max(most, p) : most), 0);
  return power.map((p) => (peak > 0 && p > 0 ? Math.max(floor, 10 * Math.log10(p / peak)) : floor));
}

/** The place in `time`, which is even and rising, that is nearest to `t`; -1 where there is none within it. */
export function nearest(time: Float64Array, t: number): number {
  if (time.length === 0) return -1;
  const at = Math.round((t - time[0]!) * PROBE_RATE);
  return at < 0 || at >= time.length ? -1 : at;
}

/** The window of time that a plot shows: the last `span` seconds, and before those have passed the first ones. */
export function windowOf(last: number, span: number): [from: number, to: number] {
  const from = Math.max(0, last - span);
  return [from, from + span];
}
