import { roundTo } from '../core/link/numbers.ts';
import { withGustNumber } from '../core/link/waves.ts';
import { GUST_NUMBERS, type GustNumber } from '../core/link/wind-numbers.ts';
import { DEFAULT_GUST, type Gust, MOST_GUSTS } from '../core/wind/wind.ts';
import { windDirection } from '../view/wind-direction.ts';
import type { Doing } from './doing.ts';
import { editedWind, putWind } from './edited-wind.ts';
import { windMessages } from './words/messages.ts';

/** Metres upwind of the tree where a gust begins that nobody aimed. */
const UPWIND = 16;
/** Metres around the tree within which a click says where a gust passes, but not from where it comes. */
const NEAR = 2;

/** A gust that is no stronger than the wind around it would not be seen. */
const ABOVE = 1.5;

const START = GUST_NUMBERS.find((n) => n.key === 'start')!;

/** What a reader can do to the gusts of the wind that is edited. */
export function gustActions({ document, session, clock, set, say }: Doing) {
  const wind = () => editedWind(document, session).wind;
  const put = (gusts: Gust[]): void => putWind(document, session, { gusts });

  return {
    /**
     * Throws a gust that starts now: at a point of the ground (metres, tree space) towards the tree, or from upwind.
     *
     * Where there are as many as can be, the one that is longest over goes; one that comes again is never over.
     */
    throwGust(at?: { readonly x: number; readonly y: number }): void {
      const along = windDirection(wind()) ?? 0;
      const aimed = at && Math.hypot(at.x, at.y) > NEAR;
      const direction = aimed ? Math.atan2(-at.y, -at.x) : along;
      const from = at ?? { x: -UPWIND * Math.cos(along), y: -UPWIND * Math.sin(along) };
      // Up to the next digit that a link keeps: the past stays what it was.
      const start = roundTo(START, Math.ceil(clock.time * 10 ** START.decimals - 1e-6) / 10 ** START.decimals);
      const { gusts, waves } = wind();
      const amplitude = waves.reduce((most, wave) => Math.max(most, ABOVE * wave.amplitude), DEFAULT_GUST.amplitude);
      const gust: Gust = { ...DEFAULT_GUST, ...from, start, direction, amplitude };
      const over = (g: Gust): number => (g.repeat > 0 ? Number.POSITIVE_INFINITY : g.start);
      const oldest = gusts.reduce((a, g, i) => (over(g) < over(gusts[a]!) ? i : a), 0);
      put([...(gusts.length < MOST_GUSTS ? gusts : gusts.toSpliced(oldest, 1)), gust]);
      if (!document.getState().blowing) set({ blowing: true });
      session.setState({ gust: wind().gusts.length - 1 });
      say(windMessages.gustStarts(start));
    },
    /** The next click on the ground throws a gust, until this is called with false. */
    setThrowing(throwing: boolean): void {
      session.setState({ throwing });
      say(throwing ? windMessages.aiming : '');
    },
    chooseGust: (gust: number | null) => session.setState({ gust }),
    setGustNumber(index: number, number: GustNumber, shown: number): void {
      put(wind().gusts.map((gust, i) => (i === index ? withGustNumber(gust, number, shown) : gust)));
    },
    setGustStart(index: number, seconds: number): void {
      put(wind().gusts.map((gust, i) => (i === index ? withGustNumber(gust, START, seconds) : gust)));
    },
    removeGust(index: number): void {
      put(wind().gusts.toSpliced(index, 1));
      session.setState({ gust: null });
      say(windMessages.gustRemoved);
    },
    removeGusts(): void {
      put([]);
      session.setState({ gust: null });
      say(windMessages.gustsRemoved);
    },
  };
}
