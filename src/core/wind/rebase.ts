import { phaseAt, wrapTurns } from './force.ts';
import type { Wave, Wind } from './wind.ts';

/**
 * The wave with another speed or wavelength that stands at the same phase at `time` seconds (at the origin): its `phase`
 * changes, so that the wind stays a function of its document and the time. Source: equations.md 5.6 (erratum E24).
 */
export function rebaseWave(wave: Wave, change: Partial<Pick<Wave, 'speed' | 'wavelength'>>, time: number): Wave {
  const next = { ...wave, ...change };
  return { ...next, phase: wrapTurns(phaseAt(wave, time) - (next.speed / next.wavelength) * time) };
}

/**
 * `next` with each wave rebased whose speed or wavelength differs from that of `previous` while its phase field does not:
 * what an edit at `time` seconds turns a document into, so that no crest jumps.
 */
export function rebaseWind(previous: Wind, next: Wind, time: number): Wind {
  // Where waves came, went or changed places, none was edited: what stands at an index now is another wave.
  if (next.waves.length !== previous.waves.length) return next;
  const waves = next.waves.map((wave, i) => {
    const old = previous.waves[i];
    if (old === undefined || old.phase !== wave.phase || previous.waves.includes(wave)) return wave;
    if (old.speed === wave.speed && old.wavelength === wave.wavelength) return wave;
    return { ...wave, phase: rebaseWave(old, wave, time).phase };
  });
  return { ...next, waves };
}
