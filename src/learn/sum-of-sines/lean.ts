import { meanPush } from '../../core/wind/force.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { type FigureSpec, numberOf, switchOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { windLink } from '../wind-link.ts';
import { AskedWind, someWaves, windOf } from './waves.ts';

/** Seconds of the path. */
const PAST = 60;
const EDGE = 0.3;

/** Where the mean of the force of a wind of waves is: the sum of D A m(k); 0 where the means are taken off. */
export function meanForce({ waves, zeroMean }: Wind): Point {
  let [x, y] = [0, 0];
  if (zeroMean) return [0, 0];
  for (const { amplitude, direction, sharpness } of waves) {
    const m = amplitude * meanPush(sharpness);
    x += m * Math.cos(direction);
    y += m * Math.sin(direction);
  }
  return [x, y];
}

/** The same, measured: the mean of the force at the origin over an hour, asked `rate` times a second. */
export function measuredMean(wind: Wind, rate = 2, seconds = 3600): Point {
  const asked = new AskedWind(wind);
  let [x, y] = [0, 0];
  const count = rate * seconds;
  for (let i = 0; i < count; i++) {
    const [fx, fy] = asked.at(0, 0, i / rate);
    x += fx / count;
    y += fy / count;
  }
  return [x, y];
}

const windFor = (values: Values): Wind => {
  const heading = (numberOf(values, 'heading') * Math.PI) / 180;
  return windOf(someWaves(numberOf(values, 'waves'), numberOf(values, 'sharpness'), heading, 1.6), {
    zeroMean: switchOf(values, 'zero'),
  });
};

class Lean extends PlaneFigure {
  #wind = windOf([]);
  #asked = new AskedWind(this.#wind);
  #mean: Point = [0, 0];
  #made: Values | null = null;

  draw(values: Values, time: number): Record<string, string> {
    if (this.#made !== values) this.#make(values);
    const plane = this.plane;
    const { force, rest, answer, soft, line } = this.host.colours();
    plane.begin({ x: [-0.1, EDGE], y: [-0.16, 0.16], equal: true });
    for (const radius of [0.1, 0.2, 0.3]) plane.circle([0, 0], radius, { colour: line, width: 1, alpha: 0.5 });
    for (const radius of [0.1, 0.2]) plane.text([radius, 0], `${radius} m`, { size: 12, colour: soft, shift: [4, -4] });
    const at = (t: number): Point => this.#asked.at(0, 0, t);
    const steps = 900;
    let before = at(time - PAST);
    for (let i = 1; i <= steps; i++) {
      const next = at(time - PAST * (1 - i / steps));
      plane.line(before, next, { colour: force, width: 2, alpha: 0.06 + 0.8 * (i / steps) ** 2 });
      before = next;
    }
    plane.arrow([0, 0], before, { colour: force, width: 3.5 });
    plane.dot([0, 0], 3);
    const theory = meanForce(this.#wind);
    const size = 0.008;
    const [mx, my] = this.#mean;
    plane.line([mx - size, my - size], [mx + size, my + size], { colour: answer, width: 3 });
    plane.line([mx - size, my + size], [mx + size, my - size], { colour: answer, width: 3 });
    plane.text([mx, my], 'mean', { colour: answer, shift: [14, -12] });
    plane.circle(theory, 1.9 * size, { colour: rest, width: 2 });
    return {
      mean: Math.hypot(mx, my).toFixed(4),
      theory: Math.hypot(...theory).toFixed(4),
      now: Math.hypot(...before).toFixed(3),
    };
  }

  handles(values: Values) {
    const far = 0.26;
    const degrees = numberOf(values, 'heading');
    const heading = (degrees * Math.PI) / 180;
    return [
      this.plane.handle({
        id: 'heading',
        label: 'Direction of the wind',
        at: [far * Math.cos(heading), far * Math.sin(heading)],
        colour: this.host.colours().rest,
        said: `${degrees} degrees`,
        move: (x, y) => this.host.set('heading', (Math.atan2(y, x) * 180) / Math.PI),
        turn: (steps) => this.host.set('heading', ((degrees + 2 * steps + 540) % 360) - 180),
      }),
    ];
  }

  text(): string {
    return `The tip of the force wanders about a mean of ${Math.hypot(...this.#mean).toFixed(2)} metres.`;
  }

  #make(values: Values): void {
    this.#wind = windFor(values);
    this.#asked = new AskedWind(this.#wind);
    this.#mean = measuredMean(this.#wind);
    this.#made = values;
  }
}

/** The force at one place through time, and its mean. */
export const lean: FigureSpec = {
  id: 'lean',
  title: 'The tip of the force',
  aspect: 1.5,
  moves: true,
  begin: PAST,
  controls: [
    { id: 'waves', label: 'Waves', min: 1, max: 4, step: 1, value: 4 },
    { id: 'sharpness', label: 'Sharpness k', min: 0.5, max: 6, step: 0.1, value: 2.2 },
    { id: 'zero', label: 'Take the mean off', value: false },
  ],
  dragged: [{ id: 'heading', min: -180, max: 180, step: 1, value: 23 }],
  readouts: [
    { id: 'mean', label: 'Mean of an hour, measured', unit: 'm' },
    { id: 'theory', label: 'Mean by the formula', unit: 'm' },
    { id: 'now', label: 'Force now', unit: 'm' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: (host) => new Lean(host),
};
