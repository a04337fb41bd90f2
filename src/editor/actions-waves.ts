import type { WaveNumber } from '../core/link/numbers.ts';
import { withNumber } from '../core/link/waves.ts';
import { rebaseWave } from '../core/wind/rebase.ts';
import { DEFAULT_WAVE, MOST_WAVES, type Wave } from '../core/wind/wind.ts';
import { windDirection } from '../view/wind-direction.ts';
import type { Doing } from './doing.ts';
import { editedWind, putWind } from './edited-wind.ts';
import { windMessages } from './words/messages.ts';

/** Turns from one added wave to the next: the golden ratio, so that no two are in step. */
const GOLDEN = 0.618034;

/** What a reader can do to the waves of the wind that is edited. */
export function waveActions({ document, session, clock, say }: Doing) {
  const wind = () => editedWind(document, session).wind;
  const put = (waves: Wave[]): void => putWind(document, session, { waves });
  const change = (index: number, to: (wave: Wave) => Wave): void =>
    put(wind().waves.map((wave, i) => (i === index ? to(wave) : wave)));

  return {
    setWaveOn: (index: number, on: boolean) => change(index, (wave) => ({ ...wave, on })),
    setWaveSolo: (index: number, solo: boolean) => change(index, (wave) => ({ ...wave, solo, on: wave.on || solo })),
    setWaveNumber: (index: number, number: WaveNumber, shown: number) =>
      change(index, (wave) => {
        const next = withNumber(wave, number, shown);
        return number.key === 'phase' ? next : rebaseWave(wave, next, clock.time);
      }),
    /** One more, along the wind; returns its place, or null where there are as many as can be. */
    addWave(): number | null {
      const { waves } = wind();
      if (waves.length >= MOST_WAVES) return null;
      const direction = windDirection(wind()) ?? 0;
      put([...waves, { ...DEFAULT_WAVE, direction, phase: (waves.length * GOLDEN) % 1 }]);
      say(windMessages.waveAdded(waves.length + 1));
      return waves.length;
    },
    /** A copy right behind it, half a turn later. */
    copyWave(index: number): void {
      const { waves } = wind();
      const wave = waves[index];
      if (!wave || waves.length >= MOST_WAVES) return;
      put(waves.toSpliced(index + 1, 0, { ...wave, solo: false, phase: (wave.phase + 0.5) % 1 }));
      say(windMessages.waveCopied(index + 2, index + 1));
    },
    removeWave(index: number): void {
      put(wind().waves.toSpliced(index, 1));
      say(windMessages.waveRemoved(index + 1));
    },
    moveWave(from: number, to: number): void {
      const { waves } = wind();
      const wave = waves[from];
      const place = Math.min(waves.length - 1, Math.max(0, to));
      if (!wave || place === from) return;
      put(waves.toSpliced(from, 1).toSpliced(place, 0, wave));
      say(windMessages.waveMoved(place + 1, waves.length));
    },
  };
}
