import FFT from 'fft.js';

/** How much of each frequency a signal has. */
export interface Spectrum {
  /** Hertz, from 0 to half the rate, evenly. */
  readonly frequency: Float64Array;
  /** One-sided power density, (unit of the signal)^2 a hertz; its integral is the variance. */
  readonly power: Float64Array;
}

/** The largest power of two that is not above `n`; n >= 1. */
const floorPower = (n: number): number => 2 ** Math.floor(Math.log2(n));

/** Plans of the transform by length: a plot asks for the same ones again and again. */
const plans = new Map<number, { fft: FFT; input: number[]; output: number[]; window: Float64Array; weight: number }>();

function planOf(length: number) {
  let plan = plans.get(length);
  if (plan === undefined) {
    const fft = new FFT(length);
    // The periodic Hann window: half-overlapping copies add up to 1.
    const window = Float64Array.from({ length }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / length));
    const weight = window.reduce((sum, w) => sum + w * w, 0);
    plan = { fft, input: new Array<number>(length).fill(0), output: fft.createComplexArray(), window, weight };
    plans.set(length, plan);
  }
  return plan;
}

/**
 * Power density of `signal`, sampled `rate` times a second, by Welch's method: segments of at most `segment` samples (a power of two),
 * overlapping by half, each without its mean, under a Hann window, averaged. Fewer than 16 samples give no spectrum.
 * Source: Welch 1967, "The use of fast Fourier transform for the estimation of power spectra".
 */
export function spectrumOf(signal: ArrayLike<number>, rate: number, segment = 1024): Spectrum {
  const n = signal.length;
  if (n < 16) return { frequency: new Float64Array(0), power: new Float64Array(0) };
  const length = Math.min(floorPower(segment), floorPower(n));
  const { fft, input, output, window, weight } = planOf(length);
  const bins = length / 2 + 1;
  const power = new Float64Array(bins);
  const hop = length / 2;
  let segments = 0;
  // From the end backwards: where the segments do not fit evenly, the oldest samples are the ones left out.
  for (let start = n - length; start >= 0; start -= hop) {
    let mean = 0;
    for (let i = 0; i < length; i++) mean += signal[start + i];
    mean /= length;
    for (let i = 0; i < length; i++) input[i] = (signal[start + i] - mean) * window[i];
    fft.realTransform(output, input);
    for (let k = 0; k < bins; k++) power[k] += output[2 * k] ** 2 + output[2 * k + 1] ** 2;
    segments++;
  }
  for (let k = 0; k < bins; k++) {
    const sides = k === 0 || k === bins - 1 ? 1 : 2;
    power[k] *= sides / (segments * weight * rate);
  }
  return { frequency: Float64Array.from({ length: bins }, (_, k) => (k * rate) / length), power };
}

/**
 * The frequency in hertz at which a spectrum is greatest, between bins by a parabola through the logarithms of three; the bin at 0 is
 * left out. null where the signal does not move.
 */
export function dominantFrequency({ frequency, power }: Spectrum): number | null {
  let best = 0;
  for (let k = 1; k < power.length; k++) if (best === 0 || power[k] > power[best]) best = k;
  if (best === 0 || !(power[best] > 1e-18)) return null;
  if (best === 1 || best === power.length - 1) return frequency[best];
  const [a, b, c] = [best - 1, best, best + 1].map((k) => Math.log(Math.max(power[k], 1e-30))) as [
    number,
    number,
    number,
  ];
  const curve = a - 2 * b + c;
  const shift = curve < 0 ? Math.max(-0.5, Math.min(0.5, (0.5 * (a - c)) / curve)) : 0;
  return frequency[best] + shift * (frequency[1] - frequency[0]);
}
