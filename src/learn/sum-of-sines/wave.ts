import { DEFAULT_WAVE } from '../../core/wind/wind.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { windLink } from '../wind-link.ts';
import { ForceMap } from './force-map.ts';
import { AskedWind, windOf } from './waves.ts';

const SPEED = 6;
/** Metres of the map that the arrow has for a metre of amplitude. */
const REACH = 40;

const windFor = (values: Values) =>
  windOf([
    {
      ...DEFAULT_WAVE,
      amplitude: numberOf(values, 'amplitude'),
      direction: (numberOf(values, 'direction') * Math.PI) / 180,
      wavelength: numberOf(values, 'wavelength'),
      speed: SPEED,
      sharpness: 2,
      // A crest in the middle at the beginning.
      phase: 0.75,
    },
  ]);

class Wave extends PlaneFigure {
  readonly #map: ForceMap;

  constructor(host: FigureHost) {
    super(host);
    this.#map = new ForceMap(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const plane = this.plane;
    const asked = new AskedWind(windFor(values));
    plane.begin({ x: [-24, 24], y: [-13, 13], equal: true, margin: { top: 0, right: 0, bottom: 0, left: 0 } });
    this.#map.draw(plane, (x, y) => asked.at(x, y, time), 0.4);
    const { ink, force } = this.host.colours();
    const [tip, back] = this.#places(values);
    const wavelength = numberOf(values, 'wavelength');
    const along: Point = [-back[0] / wavelength, -back[1] / wavelength];
    for (const [x, y] of [[0, 0], back] as const)
      plane.line([x - 99 * along[1], y + 99 * along[0]], [x + 99 * along[1], y - 99 * along[0]], {
        colour: ink,
        dash: [6, 5],
        width: 1,
      });
    plane.line([0, 0], back, { colour: ink, width: 1 });
    plane.text([back[0] / 2, back[1] / 2], 'λ', { italic: true, size: 17, align: 'center', shift: [0, -8] });
    plane.arrow([0, 0], tip, { colour: force, width: 4 });
    plane.text(tip, 'A D', { italic: true, size: 15, colour: force, shift: [12, -8] });
    const [fx, fy] = asked.at(0, 0, time);
    return {
      period: (wavelength / SPEED).toFixed(2),
      push: Math.hypot(fx, fy).toFixed(3),
      number: signed((2 * Math.PI) / wavelength),
    };
  }

  handles(values: Values) {
    const [tip, back] = this.#places(values);
    const host = this.host;
    return [
      this.plane.handle({
        id: 'tip',
        label: 'Tip of the wave’s arrow',
        at: tip,
        colour: host.colours().force,
        said: `${numberOf(values, 'amplitude')} metres towards ${numberOf(values, 'direction')} degrees`,
        move: (x, y) => {
          host.set('amplitude', Math.hypot(x, y) / REACH);
          host.set('direction', (Math.atan2(y, x) * 180) / Math.PI);
        },
      }),
      this.plane.handle({
        id: 'crest',
        label: 'The crest before',
        at: back,
        said: `${numberOf(values, 'wavelength')} metres behind`,
        move: (x, y) => host.set('wavelength', Math.hypot(x, y)),
      }),
    ];
  }

  text(values: Values): string {
    return `A wave of ${numberOf(values, 'wavelength')} metres runs towards ${numberOf(values, 'direction')} degrees and pushes there by up to ${numberOf(values, 'amplitude')} metres.`;
  }

  /** The tip of the arrow, and the crest before. */
  #places(values: Values): [Point, Point] {
    const direction = (numberOf(values, 'direction') * Math.PI) / 180;
    const at = (far: number): Point => [far * Math.cos(direction), far * Math.sin(direction)];
    return [at(REACH * numberOf(values, 'amplitude')), at(-numberOf(values, 'wavelength'))];
  }
}

/** One wave from above: amplitude, direction and wavelength to drag. */
export const wave: FigureSpec = {
  id: 'wave',
  title: 'One wave from above',
  aspect: 1.85,
  moves: true,
  controls: [
    { id: 'amplitude', label: 'Amplitude A', unit: 'm', min: 0.02, max: 0.4, step: 0.01, value: 0.25 },
    { id: 'direction', label: 'Direction of D', unit: '°', min: -180, max: 180, step: 1, value: 20 },
    { id: 'wavelength', label: 'Wavelength λ', unit: 'm', min: 4, max: 24, step: 0.5, value: 15 },
  ],
  readouts: [
    { id: 'period', label: 'From crest to crest', unit: 's' },
    { id: 'number', label: 'Wave number 2π/λ', unit: 'rad/m' },
    { id: 'push', label: 'Push in the middle, now', unit: 'm' },
  ],
  open: (values) => windLink(windFor(values)),
  stage: (host) => new Wave(host),
};
