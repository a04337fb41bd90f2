import { gustArrival } from '../../core/wind/gust.ts';
import { DEFAULT_GUST, type Gust, type Wind } from '../../core/wind/wind.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { Plane, type Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { windLink } from '../wind-link.ts';
import { ForceMap } from './force-map.ts';
import { AskedWind, windOf } from './waves.ts';

/** Seconds after which the figure begins anew. */
const LOOP = 14;
const PEAK = 0.2;
const SPLIT = 0.66;

/** Where the gust starts and where it is asked, metres. */
const fromOf = (values: Values): Point => [numberOf(values, 'fx'), numberOf(values, 'fy')];
const probeOf = (values: Values): Point => [numberOf(values, 'px'), numberOf(values, 'py')];

const gustFor = (values: Values): Gust => ({
  ...DEFAULT_GUST,
  start: 0.5,
  x: numberOf(values, 'fx'),
  y: numberOf(values, 'fy'),
  direction: 0.15,
  speed: numberOf(values, 'speed'),
  amplitude: PEAK,
  rise: numberOf(values, 'rise'),
  fall: 2.5,
  width: numberOf(values, 'width'),
});

const windFor = (values: Values): Wind => windOf([], { gusts: [gustFor(values)] });

/** When the gust of a wind is first felt at a place, seconds, by asking for the force; null: not within `until` seconds. */
export function firstFelt(wind: Wind, [x, y]: Point, until: number): number | null {
  const asked = new AskedWind(wind);
  const felt = (t: number): boolean => Math.hypot(...asked.at(x, y, t)) > 1e-9;
  let low = 0;
  let high = Number.NaN;
  for (let t = 0; t <= until; t += 0.05) {
    if (felt(t)) {
      high = t;
      break;
    }
    low = t;
  }
  if (Number.isNaN(high)) return null;
  for (let i = 0; i < 20; i++) {
    const middle = (low + high) / 2;
    if (felt(middle)) high = middle;
    else low = middle;
  }
  return high;
}

class GustFront extends PlaneFigure {
  readonly #trace: Plane;
  readonly #map: ForceMap;

  constructor(host: FigureHost) {
    super(host);
    this.#trace = new Plane(host);
    this.#map = new ForceMap(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const host = this.host;
    const now = time % LOOP;
    const wind = windFor(values);
    const [from, probe] = [fromOf(values), probeOf(values)];
    const asked = new AskedWind(wind);
    const margin = marginsOf(host.size, { y: [0, SPLIT] }, { top: 0, left: 0, right: 0, bottom: 0 });
    this.plane.begin({ x: [-30, 30], y: [-9, 9], equal: true, margin });
    this.#map.draw(this.plane, (x, y) => asked.at(x, y, now), PEAK);
    const gust = gustFor(values);
    const ahead: Point = [Math.cos(gust.direction), Math.sin(gust.direction)];
    const { ink } = host.colours();
    this.plane.line(from, [from[0] + 99 * ahead[0], from[1] + 99 * ahead[1]], {
      colour: ink,
      width: 1,
      dash: [2, 5],
    });
    this.#front(gust, ahead, now);
    const arrives = gustArrival(gust, ...probe);
    this.#past(asked, probe, now, arrives);
    const felt = firstFelt(wind, probe, LOOP);
    return {
      predicted: arrives.toFixed(2),
      felt: felt === null ? 'not yet' : felt.toFixed(2),
      now: Math.hypot(...asked.at(...probe, now)).toFixed(3),
    };
  }

  handles(values: Values) {
    const put = (name: 'f' | 'p', to: number, up: number): void => {
      const [x, y] = this.plane.within([to, up], 1);
      this.host.set(`${name}x`, x);
      this.host.set(`${name}y`, y);
    };
    return [
      this.plane.handle({
        id: 'from',
        label: 'Start of the gust',
        at: fromOf(values),
        colour: this.host.colours().velocity,
        move: (x, y) => put('f', x, y),
      }),
      this.plane.handle({
        id: 'probe',
        label: 'Probe',
        at: probeOf(values),
        move: (x, y) => put('p', x, y),
      }),
    ];
  }

  text(values: Values): string {
    const arrives = gustArrival(gustFor(values), ...probeOf(values));
    return `A front runs to the right and reaches the probe ${arrives.toFixed(1)} seconds after the beginning.`;
  }

  /** Where the front is: across the direction, as wide as it says. */
  #front({ x: fromX, y: fromY, speed, start, width }: Gust, [dx, dy]: Point, now: number): void {
    const far = Math.max(0, (now - start) * speed);
    const [x, y] = [fromX + far * dx, fromY + far * dy];
    const half = width / 2;
    this.plane.line([x - half * dy, y + half * dx], [x + half * dy, y - half * dx], {
      colour: this.host.colours().velocity,
      width: 2,
    });
  }

  #past(asked: AskedWind, probe: Point, now: number, arrives: number): void {
    const { size } = this.host;
    const margin = marginsOf(size, { y: [SPLIT, 1] }, { top: 14, bottom: 26, left: 44, right: 14 });
    const trace = this.#trace;
    const { force, velocity, soft, answer } = this.host.colours();
    trace.begin({ x: [0, LOOP], y: [0, 1.2 * PEAK], margin }, { keep: true });
    trace.axes({ x: 'seconds', y: 'force at the probe, m' }, 2, 0.1);
    const push = (t: number): number => Math.hypot(...asked.at(...probe, t));
    trace.graph(push, { colour: soft, width: 1.5, dash: [3, 4] });
    if (now > 0.05) trace.graph(push, { colour: force, width: 2.5 }, [0, now]);
    trace.line([arrives, 0], [arrives, 1.1 * PEAK], { colour: velocity, dash: [5, 4] });
    trace.dot([now, push(now)], 4, { colour: answer });
  }
}

/** One gust front that crosses the meadow. */
export const gust: FigureSpec = {
  id: 'gust',
  title: 'A gust front',
  aspect: 1.7,
  moves: true,
  begin: 4,
  controls: [
    { id: 'speed', label: 'Speed c', unit: 'm/s', min: 3, max: 20, step: 0.5, value: 8 },
    { id: 'rise', label: 'Rise r', unit: 's', min: 0.2, max: 3, step: 0.1, value: 0.8 },
    { id: 'width', label: 'Width w', unit: 'm', min: 5, max: 60, step: 1, value: 30 },
  ],
  dragged: [
    { id: 'fx', min: -100, max: 100, step: 0.05, value: -24 },
    { id: 'fy', min: -100, max: 100, step: 0.05, value: 0 },
    { id: 'px', min: -100, max: 100, step: 0.05, value: 14 },
    { id: 'py', min: -100, max: 100, step: 0.05, value: 3 },
  ],
  readouts: [
    { id: 'predicted', label: 'Should arrive after', unit: 's' },
    { id: 'felt', label: 'Is felt after', unit: 's' },
    { id: 'now', label: 'Force at the probe now', unit: 'm' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: (host) => new GustFront(host),
};
