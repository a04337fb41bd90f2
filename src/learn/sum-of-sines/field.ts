import { speedOfForce } from '../../core/wind/speed.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { Plane, type Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { windLink } from '../wind-link.ts';
import { ForceMap } from './force-map.ts';
import { AskedWind, someWaves, windOf } from './waves.ts';

const DEGREE = Math.PI / 180;
const HEADING = 15 * DEGREE;
/** Seconds that the trace looks back. */
const PAST = 20;
/** Force of full colour, metres. */
const MOST = 0.24;
const SPLIT = 0.68;

const windFor = (values: Values) =>
  windOf(
    someWaves(numberOf(values, 'waves'), numberOf(values, 'sharpness'), HEADING, numberOf(values, 'spread') * DEGREE),
  );

const probeOf = (values: Values): Point => [numberOf(values, 'px'), numberOf(values, 'py')];

class Field extends PlaneFigure {
  readonly #trace: Plane;
  readonly #map: ForceMap;
  #asked = new AskedWind(windOf([]));
  #values: Values | null = null;
  #now = 0;

  constructor(host: FigureHost) {
    super(host);
    this.#trace = new Plane(host);
    this.#map = new ForceMap(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const host = this.host;
    if (values !== this.#values) this.#asked = new AskedWind(windFor(values));
    this.#values = values;
    this.#now = time;
    const asked = this.#asked;
    const margin = marginsOf(host.size, { y: [0, SPLIT] }, { top: 0, left: 0, right: 0, bottom: 0 });
    this.plane.begin({ x: [-30, 30], y: [-9, 9], equal: true, margin });
    this.#map.draw(this.plane, (x, y) => asked.at(x, y, time), MOST);
    this.#scale();
    const [x, y] = probeOf(values);
    const force = asked.at(x, y, time);
    const { ink, answer } = host.colours();
    this.plane.arrow([x, y], [x + 30 * force[0], y + 30 * force[1]], { colour: ink, width: 3 });
    const mean = this.#past([x, y], time, answer);
    const size = Math.hypot(...force);
    return { force: size.toFixed(3), speed: speedOfForce(size).toFixed(1), mean: mean.toFixed(3) };
  }

  handles(values: Values) {
    const [x, y] = probeOf(values);
    return [
      this.plane.handle({
        id: 'probe',
        label: 'Probe',
        at: [x, y],
        said: `${signed(x, 0)} metres along, ${signed(y, 0)} metres aside`,
        move: (to, up) => {
          const [px, py] = this.plane.within([to, up], 1);
          this.host.set('px', px);
          this.host.set('py', py);
        },
      }),
    ];
  }

  text(values: Values): string {
    const [fx, fy] = this.#asked.at(...probeOf(values), this.#now);
    return `Fronts of force cross the meadow to the right. At the probe the force is ${Math.hypot(fx, fy).toFixed(2)} metres.`;
  }

  #scale(): void {
    const { x, y } = this.plane;
    const [left, low] = [x[0] + 1.2, y[0] + 1];
    this.plane.line([left, low], [left + 10, low], { width: 2 });
    this.plane.text([left + 5, low], '10 m', { align: 'center', baseline: 'bottom', shift: [0, -3], size: 12 });
  }

  /** The last seconds at the probe; their mean. */
  #past(probe: Point, time: number, colour: string): number {
    const host = this.host;
    const margin = marginsOf(host.size, { y: [SPLIT, 1] }, { top: 14, bottom: 24, left: 44, right: 14 });
    this.#trace.begin({ x: [-PAST, 0], y: [0, 0.36], margin }, { keep: true });
    this.#trace.axes({ y: 'force at the probe, m' }, 5, 0.1);
    // Above what any of these winds reaches.
    this.#trace.text([0, 0.36], 'seconds ago', { size: 12, align: 'right', baseline: 'top' });
    const steps = Math.min(400, Math.max(60, Math.round(host.size.width / 2)));
    let sum = 0;
    const points = Array.from({ length: steps + 1 }, (_, i): Point => {
      const ago = PAST * (i / steps - 1);
      const size = Math.hypot(...this.#asked.at(...probe, time + ago));
      sum += size / (steps + 1);
      return [ago, size];
    });
    const { force, rest } = host.colours();
    this.#trace.area([[-PAST, 0], ...points, [0, 0]], { colour: force, alpha: 0.15 });
    this.#trace.line([-PAST, sum], [0, sum], { colour: rest, dash: [4, 4], width: 1 });
    this.#trace.polyline(points, { colour: force, width: 2 });
    const last = points.at(-1);
    if (last) this.#trace.dot(last, 4, { colour });
    return sum;
  }
}

/** The field of the wind from above, with a probe. */
export const field: FigureSpec = {
  id: 'field',
  title: 'The wind from above',
  aspect: 1.7,
  moves: true,
  begin: 40,
  controls: [
    { id: 'waves', label: 'Waves', min: 1, max: 4, step: 1, value: 4 },
    { id: 'sharpness', label: 'Sharpness k', min: 0.5, max: 6, step: 0.1, value: 2.2 },
    { id: 'spread', label: 'Spread of directions', unit: '°', min: 0, max: 180, step: 5, value: 90 },
  ],
  // Where it is asked, metres: along the wind and aside.
  dragged: [
    { id: 'px', min: -100, max: 100, step: 0.05, value: 8 },
    { id: 'py', min: -100, max: 100, step: 0.05, value: -3 },
  ],
  readouts: [
    { id: 'force', label: 'Force at the probe', unit: 'm' },
    { id: 'speed', label: 'That is a wind of', unit: 'm/s' },
    { id: 'mean', label: 'Mean of 20 s', unit: 'm' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: (host) => new Field(host),
};
