import { html, svg, type TemplateResult } from 'lit';
import { createWaveUniforms, wavesAt, windForce } from '../../core/wind/force.ts';
import type { Wind } from '../../core/wind/wind.ts';

const SAMPLES = 240;
/** Metres of force that fill half of the height: calm winds stay low, gales do not leave the page. */
const HALF = 0.06;

/** The force at the foot of the tree over `seconds` from `start` on, as an area. */
export function waveform(wind: Wind, blowing: boolean, start: number, seconds: number): TemplateResult {
  const waves = createWaveUniforms();
  const points = Array.from({ length: SAMPLES + 1 }, (_, i) => {
    wavesAt(wind, start + (i / SAMPLES) * seconds, undefined, waves);
    const [x, y] = blowing ? windForce(waves, 0, 0) : [0, 0];
    const force = Math.hypot(x, y);
    return `${i},${(100 - 96 * (force / (force + HALF))).toFixed(1)}`;
  });
  return html`<svg class="waveform" viewBox="0 0 ${SAMPLES} 100" preserveAspectRatio="none" aria-hidden="true">${svg`
    <path class="area" d="M0,100 L${points.join(' ')} L${SAMPLES},100 Z"></path>
    <path class="line" d="M${points.join(' ')}"></path>`}</svg>`;
}
