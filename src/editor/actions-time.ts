import { roundTime } from '../core/link/link.ts';
import { LINK_NUMBERS, roundTo } from '../core/link/numbers.ts';
import type { Doing } from './doing.ts';
import { windMessages } from './words/messages.ts';

/** How fast time runs in slow motion. */
export const SLOW = 0.25;

/** What a reader can do to the clock. */
export function timeActions({ document, clock, set, say }: Doing) {
  const play = (): void => {
    clock.play();
    set({ paused: false });
    say(windMessages.playing);
  };
  const pause = (): void => {
    clock.pause();
    set({ paused: true, time: roundTime(clock.time) });
    say(windMessages.paused);
  };
  const setRate = (rate: number): void => {
    clock.rate = roundTo(LINK_NUMBERS.rate, rate);
    set({ rate: clock.rate });
  };
  return {
    play,
    pause,
    toggle: (): void => (document.getState().paused ? play() : pause()),
    step(steps: number): void {
      if (!document.getState().paused) pause();
      clock.step(steps);
      set({ time: roundTime(clock.time) });
    },
    seek(seconds: number): void {
      clock.seek(roundTime(seconds));
      set({ time: roundTime(clock.time) });
    },
    setRate,
    /** Slow motion on or off. */
    toggleSlow(): void {
      const slow = document.getState().rate >= 1;
      setRate(slow ? SLOW : 1);
      say(slow ? windMessages.slow : windMessages.real);
    },
    time: (): number => clock.time,
  };
}
