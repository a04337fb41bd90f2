import { type LoopGap, loopWind } from '../../core/wind/loop.ts';
import type { Wind } from '../../core/wind/wind.ts';
import type { PictureOptions } from './picture-options.ts';

/** Seconds that branches which swing need in a wind until they are in the swing of it. */
const WARM = 12;

/** What is filmed: which moments, in which wind. */
export interface Film {
  /** Of each frame, seconds, exact: start + i / rate. */
  readonly times: readonly number[];
  readonly wind: Wind;
  /** What does not come around although it should. */
  readonly open: readonly LoopGap[];
}

/** The frames of a film that begins at `start` seconds; one that comes around has a wind that does. */
export function filmOf(
  wind: Wind,
  start: number,
  { rate, seconds, loop }: Pick<PictureOptions, 'rate' | 'seconds' | 'loop'>,
): Film {
  const count = Math.max(1, Math.round(rate * seconds));
  const from = loop && wind.model === 'spring' ? Math.max(start, WARM) : start;
  const times = Array.from({ length: count }, (_, i) => from + i / rate);
  if (!loop) return { times, wind, open: [] };
  // The frames decide the length: 30 frames at 30 a second come around after exactly one.
  const looped = loopWind(wind, count / rate, from);
  return { times, wind: looped.wind, open: looped.open };
}
