import { measuredResponse, type Response, springResponse } from '../../core/wind/spring-response.ts';
import { DEFAULT_WAVE } from '../../core/wind/wind.ts';
import { type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { smallTreeLink } from '../ping-pong/small-tree-link.ts';
import { Plane, type Point } from '../plane.ts';
import { tunedWind } from './models.ts';

/** Hertz that are shown, and how many experiments there are. */
const HERTZ = [0.1, 3] as const;
const DOTS = 26;
const DEGREE = 180 / Math.PI;
const SPLIT = 0.66;

class Resonance implements FigureStage {
  readonly #host: FigureHost;
  readonly #gain: Plane;
  readonly #phase: Plane;
  #made: { key: string; dots: readonly (readonly [hertz: number, answer: Response])[] } | null = null;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#gain = new Plane(host);
    this.#phase = new Plane(host);
  }

  draw(values: Values): Record<string, string> {
    const { size } = this.#host;
    const { answer, rest, velocity, soft, ink } = this.#host.colours();
    const [damping, natural, drive] = [
      numberOf(values, 'damping'),
      numberOf(values, 'natural'),
      numberOf(values, 'drive'),
    ];
    const omega = 2 * Math.PI * natural;
    const dots = this.#dots(omega, damping);
    const most = Math.max(2.5, springResponse(omega, damping, natural).amplitude * 1.15);
    const gain = this.#gain;
    const pad = { left: 48, right: 16, top: 14, bottom: 12 };
    gain.begin({ x: [0, HERTZ[1]], y: [0, most], margin: marginsOf(size, { y: [0, SPLIT] }, pad) });
    gain.grid(0.5);
    gain.axes({ y: 'gain' }, 10);
    gain.line([0, 1], [HERTZ[1], 1], { colour: rest, dash: [4, 4], width: 1 });
    gain.line([natural, 0], [natural, most], { colour: velocity, dash: [4, 4], width: 1.2 });
    gain.text([natural, most], 'natural', { colour: velocity, size: 12, baseline: 'top', shift: [6, 0] });
    gain.graph((f) => springResponse(omega, damping, f).amplitude, { colour: answer, width: 2 });
    for (const [hertz, { amplitude }] of dots) gain.dot([hertz, amplitude], 3.5, { colour: ink });
    const phase = this.#phase;
    phase.begin(
      { x: [0, HERTZ[1]], y: [-190, 10], margin: marginsOf(size, { y: [SPLIT, 1] }, { ...pad, top: 10, bottom: 42 }) },
      { keep: true },
    );
    phase.grid(0.5, 90);
    phase.axes({}, 0.5, 90);
    phase.text([HERTZ[1], -190], 'frequency of the wind, Hz', {
      size: 12,
      align: 'right',
      baseline: 'top',
      shift: [0, 22],
    });
    phase.text([HERTZ[1], 10], 'phase, degrees', { size: 12, colour: soft, align: 'right', baseline: 'top' });
    phase.graph((f) => springResponse(omega, damping, f).phase * DEGREE, { colour: answer, width: 2 });
    for (const [hertz, response] of dots) phase.dot([hertz, lateness(response)], 3, { colour: ink });
    for (const plane of [gain, phase]) plane.line([drive, plane.y[0]], [drive, plane.y[1]], { colour: ink, width: 1 });
    const [theory, measured] = [springResponse(omega, damping, drive), measuredResponse(omega, damping, drive)];
    return {
      measured: measured.amplitude.toFixed(3),
      theory: theory.amplitude.toFixed(3),
      late: (-lateness(measured)).toFixed(1),
      lateTheory: (-theory.phase * DEGREE).toFixed(1),
    };
  }

  handles(values: Values) {
    const [damping, natural, drive] = [
      numberOf(values, 'damping'),
      numberOf(values, 'natural'),
      numberOf(values, 'drive'),
    ];
    const at: Point = [drive, springResponse(2 * Math.PI * natural, damping, drive).amplitude];
    return [
      this.#gain.handle({
        id: 'drive',
        label: 'Frequency of the wind',
        at,
        ways: 'across',
        said: `${drive} hertz`,
        move: (x) => this.#host.set('drive', x),
      }),
    ];
  }

  text(values: Values): string {
    const omega = 2 * Math.PI * numberOf(values, 'natural');
    const { amplitude } = springResponse(omega, numberOf(values, 'damping'), numberOf(values, 'drive'));
    return `A wind of ${numberOf(values, 'drive')} hertz moves the branch ${amplitude.toFixed(1)} times as far as a slow one.`;
  }

  #dots(omega: number, damping: number) {
    const key = `${omega} ${damping}`;
    if (this.#made?.key !== key) {
      const [low, high] = HERTZ;
      const dots = Array.from({ length: DOTS }, (_, i) => {
        const hertz = low + ((high - low) * (i + 0.5)) / DOTS;
        return [hertz, measuredResponse(omega, damping, hertz)] as const;
      });
      this.#made = { key, dots };
    }
    return this.#made.dots;
  }
}

/** A measured phase in degrees, from 0 down to -180 and a little beyond. */
const lateness = ({ phase }: Response): number => {
  const degrees = phase * DEGREE;
  return degrees > 20 ? degrees - 360 : degrees;
};

/** Gain and lag of a branch by the frequency of the wind. */
export const resonance: FigureSpec = {
  id: 'resonance',
  title: 'Resonance',
  aspect: 1.5,
  controls: [
    { id: 'damping', label: 'Damping ζ', min: 0.04, max: 1.5, step: 0.01, value: 0.12 },
    { id: 'natural', label: 'Natural frequency', unit: 'Hz', min: 0.3, max: 2.5, step: 0.05, value: 0.8 },
    { id: 'drive', label: 'Frequency of the wind', unit: 'Hz', min: 0.1, max: 2.95, step: 0.01, value: 0.8 },
  ],
  readouts: [
    { id: 'measured', label: 'Gain, measured' },
    { id: 'theory', label: 'Gain, by theory' },
    { id: 'late', label: 'Late by, measured', unit: '°' },
    { id: 'lateTheory', label: 'Late by, by theory', unit: '°' },
  ],
  open: (values) =>
    smallTreeLink(
      tunedWind('One sine', numberOf(values, 'natural'), numberOf(values, 'damping'), {
        waves: [
          { ...DEFAULT_WAVE, amplitude: 0.15, wavelength: 30, speed: 30 * numberOf(values, 'drive'), sharpness: 1 },
        ],
      }),
    ),
  stage: (host) => new Resonance(host),
};
