import { html, svg, type TemplateResult } from 'lit';
import { createWindState, windStateAt } from '../../core/wind/fade.ts';
import { windForce } from '../../core/wind/force.ts';
import { forceOfSpeed } from '../../core/wind/speed.ts';
import { blowingWaves, type Wind } from '../../core/wind/wind.ts';

const SAMPLES = 240;
/** Metres of force that fill the height in a calm wind: its line stays low. A stronger wind fills it with all that it can do. */
const CALM = 0.3;

/** Most that a wind pushes at one place: its waves on their crests together, its strongest gust, its strongest record. */
function mostOf(wind: Wind): number {
  const waves = blowingWaves(wind).reduce((sum, { amplitude }) => sum + amplitude, 0);
  const gust = wind.gusts.reduce((most, { amplitude }) => Math.max(most, amplitude), 0);
  const speed = wind.record?.speed.reduce((most, s) => Math.max(most, s), 0) ?? 0;
  return Math.max(CALM, wind.strength * (waves + gust + forceOfSpeed(speed)));
}

/** The force at the foot of the tree over `seconds` from `start` on, where the profile of the wind is 1, as an area. */
export function waveform(wind: Wind, blowing: boolean, start: number, seconds: number): TemplateResult {
  const state = createWindState();
  const most = mostOf(wind);
  const points = Array.from({ length: SAMPLES + 1 }, (_, i) => {
    if (!blowing) return `${i},100`;
    windStateAt(wind, start + (i / SAMPLES) * seconds, undefined, state);
    const [x, y] = windForce(state, 0, 0, wind.profile.height);
    const force = Math.hypot(x, y);
    return `${i},${(100 - 96 * Math.min(1, force / most)).toFixed(1)}`;
  });
  return html`<svg class="waveform" viewBox="0 0 ${SAMPLES} 100" preserveAspectRatio="none" aria-hidden="true">${svg`
    <path class="area" d="M0,100 L${points.join(' ')} L${SAMPLES},100 Z"></path>
    <path class="line" d="M${points.join(' ')}"></path>`}</svg>`;
}
