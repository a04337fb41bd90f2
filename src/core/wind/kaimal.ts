import FFT from 'fft.js';
import { combine, hashUnit } from '../math/hash.ts';
import type { WindRecord } from './wind.ts';

/** What turbulence there shall be. */
export interface KaimalWind {
  /** Metres a second, > 0. */
  readonly meanSpeed: number;
  /** Standard deviation along the wind as a part of the mean speed: 0.1 over the sea, 0.18 over fields, 0.3 in a town. */
  readonly intensity: number;
  /** Height of the mast in metres, > 0: the higher, the larger the eddies. */
  readonly height: number;
  /** Length of the record, and from sample to sample; seconds. */
  readonly seconds: number;
  readonly step: number;
  /** Unsigned 32-bit integer: the same seed, the same wind. */
  readonly seed: number;
  /** Mean direction towards which it blows, radians from x to y; 0. */
  readonly direction?: number;
}

/** Lengths of the eddies along and across the wind as parts of the scale, and the deviation across as a part of that along. */
const ALONG = { scale: 8.1, deviation: 1 } as const;
const ACROSS = { scale: 2.7, deviation: 0.8 } as const;

/** Metres of the turbulence scale: 0.7 of the height up to 60 m. Source: IEC 61400-1 (2005), 6.3. */
const turbulenceScale = (height: number): number => 0.7 * Math.min(height, 60);

/**
 * Power density of turbulence at `frequency` hertz as a part of its variance, in seconds: 4 L/U / (1 + 6 f L/U)^(5/3), with L the length of
 * the eddies in metres and U the mean speed. Its integral over all frequencies is 1; far above U/L it falls with the power -5/3.
 * Source: Kaimal et al. 1972, "Spectral characteristics of surface-layer turbulence", in the form of IEC 61400-1 (2005), annex B.
 */
export function kaimalDensity(frequency: number, length: number, meanSpeed: number): number {
  const passing = length / meanSpeed;
  return (4 * passing) / (1 + 6 * frequency * passing) ** (5 / 3);
}

/**
 * A synthetic record of the wind at one place: mean wind, and turbulence along and across it with Kaimal's spectra, amplitudes from the
 * spectrum and phases from the seed, summed by an inverse Fourier transform. Its mean and its deviation along the wind are those asked for,
 * exactly. Source: Shinozuka & Jan 1972, "Digital simulation of random processes and its applications".
 */
export function kaimalRecord(wind: KaimalWind): WindRecord {
  const { meanSpeed, intensity, step, seed, direction = 0 } = wind;
  const count = Math.max(2, Math.round(wind.seconds / step));
  const [along, across] = [ALONG, ACROSS].map(({ scale, deviation }, i) => {
    const turbulence = series(count, step, combine(seed, i), scale * turbulenceScale(wind.height), meanSpeed);
    return turbulence.map((u) => u * deviation * intensity * meanSpeed);
  });
  const speed: number[] = [];
  const towards: number[] = [];
  for (let i = 0; i < count; i++) {
    const u = meanSpeed + along[i];
    speed.push(Math.hypot(u, across[i]));
    towards.push(direction + Math.atan2(across[i], u));
  }
  return { name: 'Kaimal', step, speed, direction: towards };
}

/** Turbulence of mean 0 and deviation 1. */
function series(count: number, step: number, seed: number, length: number, meanSpeed: number): number[] {
  // Twice as long as asked for: the end of a whole period would go on as its beginning, and both would look alike.
  const size = 2 ** Math.ceil(Math.log2(2 * count));
  const fft = new FFT(size);
  const spectrum: number[] = fft.createComplexArray();
  const resolution = 1 / (size * step);
  for (let k = 1; k < size / 2; k++) {
    const amplitude = Math.sqrt(kaimalDensity(k * resolution, length, meanSpeed) * resolution);
    const phase = 2 * Math.PI * hashUnit(combine(seed, k));
    spectrum[2 * k] = amplitude * Math.cos(phase);
    spectrum[2 * k + 1] = amplitude * Math.sin(phase);
  }
  fft.completeSpectrum(spectrum);
  const output: number[] = fft.createComplexArray();
  fft.inverseTransform(output, spectrum);
  const values = Array.from({ length: count }, (_, i) => output[2 * i]);
  const mean = values.reduce((sum, v) => sum + v, 0) / count;
  const deviation = Math.sqrt(values.reduce((sum, v) => sum + (v - mean) ** 2, 0) / count);
  return values.map((v) => (v - mean) / deviation);
}
