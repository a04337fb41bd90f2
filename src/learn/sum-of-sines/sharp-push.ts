import { appendWave, createForceUniforms, meanPush, wavesForce } from '../../core/wind/force.ts';
import { DEFAULT_WAVE } from '../../core/wind/wind.ts';

/** The push of a wave of peak 1 by its phase in turns: equation 14 as Windgrove computes it, without its mean where that is asked. */
export function sharpPush(k: number, zeroMean: boolean): (turns: number) => number {
  const uniforms = createForceUniforms();
  const wave = { ...DEFAULT_WAVE, amplitude: 1, wavelength: 1, speed: 0, sharpness: k };
  appendWave(uniforms, wave, 1, zeroMean ? 1 : 0, false, 0);
  return (turns) => wavesForce(uniforms, turns, 0)[0];
}

/**
 * The same as printed: (sin/2)^k, no number where the sine is negative and k is not whole. Source: Skjermo 2007, equation 14
 * (erratum E25).
 */
export const printedPush =
  (k: number, zeroMean: boolean) =>
  (turns: number): number =>
    (Math.sin(2 * Math.PI * turns) / 2) ** k - (zeroMean ? meanPush(k) : 0);

/** Mean of a push over a period, and the part of the period in which it has a value, 0..1; the mean is that of this part. */
export function periodOf(push: (turns: number) => number): { mean: number; valued: number; most: number } {
  const samples = 4096;
  let [sum, valued, most] = [0, 0, Number.NEGATIVE_INFINITY];
  for (let i = 0; i < samples; i++) {
    const value = push((i + 0.5) / samples);
    if (Number.isNaN(value)) continue;
    sum += value;
    valued++;
    most = Math.max(most, value);
  }
  return { mean: sum / Math.max(1, valued), valued: valued / samples, most };
}
