import { clampedFlare, stemRadius, taperRadius } from '../../core/deform/radius.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';

const LENGTH = 6;

class Radius extends PlaneFigure {
  /** Half the width of the silhouette at z, without and with the flare. */
  #radius(values: Values, z: number, flared: boolean): number {
    const radius = LENGTH * numberOf(values, 'ratio');
    const [taper] = taperRadius(z, numberOf(values, 'taper'), radius, LENGTH);
    return flared ? taper * clampedFlare(z, numberOf(values, 'flare'))[0] : taper;
  }

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-0.5, 6.5], y: [-1.6, 1.6], equal: true });
    const steps = 480;
    const side = (sign: number, f: (z: number) => number): Point[] =>
      Array.from({ length: steps + 1 }, (_, i): Point => [(LENGTH * i) / steps, sign * f(i / steps)]);
    const outline = (f: (z: number) => number): Point[] => [...side(1, f), ...side(-1, f).toReversed()];
    const body = outline((z) => this.#radius(values, z, true));
    p.area(body, { colour: c.level1, alpha: 0.3 });
    p.polyline([...body, body[0]!], { colour: c.level0, width: 2 });
    p.polyline([...side(1, (z) => this.#radius(values, z, false))], { colour: c.rest, dash: [5, 4], width: 1.5 });
    p.polyline([...side(-1, (z) => this.#radius(values, z, false))], { colour: c.rest, dash: [5, 4], width: 1.5 });
    p.line([0, 0], [LENGTH, 0], { colour: c.line, width: 1, dash: [2, 4] });
    p.line([LENGTH / 8, -1.4], [LENGTH / 8, 1.4], { colour: c.hairline, width: 1 });
    p.text([LENGTH / 8, 1.4], 'Z = 1/8', { size: 12, colour: c.soft, shift: [6, 4] });
    const at = (z: number): string => (1000 * this.#radius(values, z, true)).toFixed(0);
    // What Skjermo’s flare makes of the foot of the same stem.
    const shape = {
      taper: numberOf(values, 'taper'),
      flare: numberOf(values, 'flare'),
      lobes: 0,
      lobeDepth: 0,
      lobeFade: 0,
      bulges: 0,
      bulgeDepth: 0,
    };
    const radius = LENGTH * numberOf(values, 'ratio');
    return {
      base: at(0),
      middle: at(0.5),
      tip: at(1),
      skjermo: (1000 * stemRadius(shape, radius, LENGTH, 0, 0)[0]).toFixed(0),
    };
  }

  handles(values: Values) {
    const p = this.plane;
    const ratio = numberOf(values, 'ratio');
    const flare = numberOf(values, 'flare');
    return [
      p.handle({
        id: 'foot',
        label: 'Foot of the trunk, sets Ratio',
        at: [0, LENGTH * ratio * (1 + 0.99 * flare)],
        ways: 'up',
        colour: this.host.colours().answer,
        said: `${(LENGTH * ratio).toFixed(2)} metres`,
        move: (_, y) => this.host.set('ratio', y / LENGTH / (1 + 0.99 * flare)),
      }),
    ];
  }

  text(values: Values): string {
    return `A trunk of ${LENGTH} metres with a taper of ${numberOf(values, 'taper')}: its radius is ${(1000 * this.#radius(values, 0, true)).toFixed(0)} millimetres at the foot and ${(1000 * this.#radius(values, 0.5, true)).toFixed(0)} half way up.`;
  }
}

/** 4.4: the profile of a stem. */
export const radius: FigureSpec = {
  id: 'radius',
  title: 'Taper and flare',
  aspect: 1.9,
  controls: [
    { id: 'taper', label: 'nTaper', min: 0, max: 3, step: 0.01, value: 1 },
    { id: 'flare', label: 'Flare', min: 0, max: 3, step: 0.05, value: 0.6 },
    { id: 'ratio', label: 'Ratio', min: 0.02, max: 0.2, step: 0.005, value: 0.08 },
  ],
  readouts: [
    { id: 'base', label: 'Radius at the foot', unit: 'mm' },
    { id: 'middle', label: 'Half way up', unit: 'mm' },
    { id: 'tip', label: 'At the tip', unit: 'mm' },
    { id: 'skjermo', label: 'At the foot, as Skjermo has it', unit: 'mm' },
  ],
  stage: (host) => new Radius(host),
};
