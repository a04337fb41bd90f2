/** One line of an anemometer's file that has a time and a speed: seconds, metres a second, radians towards which it blows. */
export interface Sample {
  readonly line: number;
  readonly time: number;
  readonly speed: number;
  readonly direction: number;
}

/** The step that most times keep: the median, in seconds, with digits that mean nothing taken off; at least two times. */
export function usualStep(times: readonly number[]): number {
  const steps = times.slice(1).map((time, i) => time - times[i]);
  steps.sort((a, b) => a - b);
  return Number(steps[Math.floor(steps.length / 2)].toPrecision(6));
}

/** From angle a to angle b by the shorter way, radians in [-pi, pi). */
const turn = (a: number, b: number): number => {
  const turns = (b - a) / (2 * Math.PI);
  return (turns - Math.floor(turns + 0.5)) * 2 * Math.PI;
};

/**
 * The samples at equal steps from the first one on: speed linearly between the two around, direction by the shorter way. Times that
 * stand on a step give their sample as it is.
 */
export function resample(samples: readonly Sample[], step: number): { speed: number[]; direction: number[] } {
  const start = samples[0].time;
  const count = stepsIn(samples, step);
  const speed: number[] = [];
  const direction: number[] = [];
  let at = 0;
  for (let i = 0; i < count; i++) {
    const time = start + i * step;
    while (at < samples.length - 2 && samples[at + 1].time <= time) at++;
    const a = samples[at];
    const b = samples[at + 1];
    // A time that is off by less than a thousandth of a step is that of the sample: decimal fractions are not exact.
    const between = (time - a.time) / (b.time - a.time);
    const f = Math.abs(between - Math.round(between)) < 1e-3 ? Math.round(between) : between;
    speed.push(f === 0 ? a.speed : f === 1 ? b.speed : a.speed + (b.speed - a.speed) * f);
    direction.push(f === 0 ? a.direction : f === 1 ? b.direction : a.direction + turn(a.direction, b.direction) * f);
  }
  return { speed, direction };
}

/** How many steps there are from the first sample to the last, both counted. */
export function stepsIn(samples: readonly Sample[], step: number): number {
  return Math.floor((samples[samples.length - 1].time - samples[0].time) / step + 1e-3) + 1;
}
