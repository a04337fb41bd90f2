import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { alongX, crestNear, crestSpeed } from './crest.ts';
import { AskedWind } from './waves.ts';

const WIDE = 36;

/** Where the ruler of the wavelength begins, metres, and how far under the ground's line it lies. */
const [RULER, UNDER] = [3, -0.2];

class Upwind extends PlaneFigure {
  draw(values: Values, time: number): Record<string, string> {
    const plane = this.plane;
    const { force, wrong, answer, velocity, line, soft } = this.host.colours();
    const printed = choiceOf(values, 'form') === 'printed';
    const [wavelength, speed] = [numberOf(values, 'wavelength'), numberOf(values, 'speed')];
    const asked = new AskedWind(alongX(wavelength, speed, printed));
    const push = (x: number): number => asked.at(x, 0, time)[0];
    plane.begin({ x: [0, WIDE], y: [-0.95, 1.45], margin: { left: 0, right: 0, top: 8, bottom: 0 } });
    const colour = printed ? wrong : force;
    const crest: Point[] = [];
    for (let x = 0; x <= WIDE; x += WIDE / 240) crest.push([x, push(x)]);
    plane.area([[0, 0], ...crest, [WIDE, 0]], { colour, alpha: 0.14 });
    plane.polyline(crest, { colour, width: 2.5 });
    plane.line([0, 0], [WIDE, 0], { colour: line, width: 1 });
    plane.text([0, 0], 'push of the wind, to the right', { colour: soft, size: 12, shift: [10, -6] });
    this.#grass(push, answer);
    plane.line([RULER, UNDER], [RULER + wavelength, UNDER], { colour: soft, width: 1.5 });
    plane.line([RULER, UNDER - 0.08], [RULER, UNDER + 0.08], { colour: soft, width: 1.5 });
    plane.text([RULER, UNDER], 'λ', {
      colour: soft,
      italic: true,
      size: 15,
      align: 'right',
      baseline: 'middle',
      shift: [-6, 0],
    });
    // The crest that is on the sheet now.
    const first = crestNear(asked, wavelength, WIDE / 2, time);
    const at: Point = [first, push(first)];
    const measured = crestSpeed(alongX(wavelength, speed, printed), wavelength, time);
    plane.dot(at, 5, { colour });
    plane.arrow([first, 1.18], [first + 0.9 * measured, 1.18], { colour: velocity, width: 3 });
    plane.text([first, 1.18], `${signed(measured)} m/s`, {
      colour: velocity,
      align: measured < 0 ? 'left' : 'right',
      baseline: 'middle',
      shift: [measured < 0 ? 8 : -8, 0],
    });
    const [left, right] = [plane.toWorld(34, 24), plane.toWorld(96, 24)];
    plane.arrow(left, right, { colour: force, width: 3 });
    plane.text(left, 'D', {
      italic: true,
      size: 15,
      colour: force,
      align: 'right',
      baseline: 'middle',
      shift: [-6, 0],
    });
    return {
      ours: signed(crestSpeed(alongX(wavelength, speed, false), wavelength, time)),
      printed: signed(crestSpeed(alongX(wavelength, speed, true), wavelength, time)),
    };
  }

  handles(values: Values) {
    const wavelength = numberOf(values, 'wavelength');
    return [
      this.plane.handle({
        id: 'wavelength',
        label: 'Wavelength',
        at: [RULER + wavelength, UNDER],
        ways: 'across',
        colour: this.host.colours().soft,
        said: `${wavelength} metres`,
        move: (x) => this.host.set('wavelength', x - RULER),
      }),
    ];
  }

  text(values: Values): string {
    return choiceOf(values, 'form') === 'printed'
      ? 'Crests run to the left while they push to the right.'
      : 'Crests run to the right and push to the right.';
  }

  /** Blades that lean as they are pushed. */
  #grass(push: (x: number) => number, colour: string): void {
    const plane = this.plane;
    for (let i = 0; i < 90; i++) {
      // Uneven, and the same in every frame.
      const x = ((i + 0.5 * Math.sin(7 * i)) * WIDE) / 89;
      const high = 0.42 + 0.1 * Math.sin(13 * i);
      const lean = push(x);
      const blade = Array.from({ length: 7 }, (_, k): Point => {
        const z = k / 6;
        return [x + 1.5 * lean * high * z * z, -0.95 + high * z * (1 - 0.4 * lean * z)];
      });
      plane.polyline(blade, { colour, width: 1.8, alpha: 0.85 });
    }
  }
}

/** The sign of equation 11: which way crests run. */
export const upwind: FigureSpec = {
  id: 'upwind',
  title: 'Which way the gusts run',
  aspect: 2.3,
  moves: true,
  controls: [
    {
      id: 'form',
      label: 'Form',
      value: 'printed',
      options: [
        { value: 'ours', label: 'Ours, − t' },
        { value: 'printed', label: 'As printed, + t' },
      ],
    },
    { id: 'wavelength', label: 'Wavelength λ', unit: 'm', min: 6, max: 30, step: 0.5, value: 15 },
    { id: 'speed', label: 'Speed c', unit: 'm/s', min: 0.5, max: 8, step: 0.5, value: 3 },
  ],
  readouts: [
    { id: 'ours', label: 'A crest of ours runs at', unit: 'm/s' },
    { id: 'printed', label: 'A printed one at', unit: 'm/s' },
  ],
  stage: (host) => new Upwind(host),
};
