import { MECHANICS, MECHANICS_SIZE } from '../../core/pack/layout.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { smallTree } from '../ping-pong/small-tree.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { bareFrequency, printedFrequency, rodFrequency } from './rod.ts';

/** Powers of ten: metres, hertz. */
const X = [-1, 1.35] as const;
const Y = [-4.4, 2] as const;
const log = Math.log10;

class Natural extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const plane = this.plane;
    const { rest, answer, wrong, soft, line } = this.host.colours();
    const [length, radius] = [numberOf(values, 'length'), numberOf(values, 'radius') / 100];
    plane.begin({ x: X, y: Y, margin: { left: 60, bottom: 42, top: 14, right: 18 } });
    this.#decades(line, soft);
    // Nothing is drawn beyond the sheet.
    const within =
      (f: (length: number) => number) =>
      (x: number): number => {
        const y = log(f(10 ** x));
        return y < Y[0] || y > Y[1] ? Number.NaN : y;
      };
    plane.graph(
      within((l) => rodFrequency(l, radius)),
      { colour: rest, dash: [7, 5], width: 1.8 },
    );
    plane.graph(
      within((l) => printedFrequency(l, radius)),
      { colour: wrong, width: 2 },
    );
    plane.graph(
      within((l) => bareFrequency(l, radius)),
      { colour: answer, width: 2.6 },
    );
    this.#stems();
    plane.text([-0.7, log(printedFrequency(10 ** -0.7, radius))], 'as printed in 1995', {
      colour: wrong,
      shift: [4, -10],
    });
    // At the long end: the dots are in the way at the other.
    plane.text([X[1], log(bareFrequency(10 ** X[1], radius))], 'our trees', {
      colour: answer,
      align: 'right',
      shift: [0, -24],
    });
    const printed = printedFrequency(length, radius);
    const rod = rodFrequency(length, radius);
    // What the numbers say, where it stands.
    plane.line([log(length), Y[0]], [log(length), Y[1]], { colour: line, width: 1 });
    for (const [hertz, colour] of [
      [rod, rest],
      [printed, wrong],
    ] as const) {
      const y = log(hertz);
      if (y >= Y[0] && y <= Y[1]) plane.dot([log(length), y], 4.5, { colour });
    }
    return {
      ours: bareFrequency(length, radius).toFixed(2),
      rod: rod < 100 ? rod.toPrecision(3) : rod.toFixed(0),
      printed: (1 / printed).toFixed(0),
    };
  }

  handles(values: Values) {
    const [length, radius] = [numberOf(values, 'length'), numberOf(values, 'radius') / 100];
    return [
      this.plane.handle({
        id: 'stem',
        label: 'Length of the branch',
        at: [log(length), log(bareFrequency(length, radius))],
        ways: 'across',
        colour: this.host.colours().answer,
        said: `${length} metres`,
        move: (x) => this.host.set('length', 10 ** x),
      }),
    ];
  }

  text(values: Values): string {
    const [length, radius] = [numberOf(values, 'length'), numberOf(values, 'radius') / 100];
    return `A branch of ${length} metres and ${numberOf(values, 'radius')} centimetres swings ${bareFrequency(length, radius).toFixed(2)} times a second.`;
  }

  /** Every piece of the small tree: the first of each stem stands for it. */
  #stems(): void {
    const { mechanics, pieceCount } = smallTree().packed;
    const { level0, level1, level2, level3 } = this.host.colours();
    for (let i = 0; i < pieceCount; i++) {
      const at = MECHANICS_SIZE * i;
      const length = mechanics[at + MECHANICS.LENGTH] ?? 1;
      const hertz = (mechanics[at + MECHANICS.OMEGA] ?? 1) / (2 * Math.PI);
      const colour = [level0, level1, level2, level3][mechanics[at + MECHANICS.LEVEL] ?? 0];
      this.plane.dot([log(length), log(hertz)], 3.5, { colour: colour ?? level3, alpha: 0.85 });
    }
  }

  #decades(line: string, soft: string): void {
    const plane = this.plane;
    const { hairline } = this.host.colours();
    for (const [metres, name] of [
      [0.1, '10 cm'],
      [1, '1 m'],
      [10, '10 m'],
    ] as const) {
      plane.line([log(metres), Y[0]], [log(metres), Y[1]], { colour: hairline, width: 1 });
      plane.text([log(metres), Y[0]], name, {
        colour: soft,
        size: 12,
        align: metres < 1 ? 'left' : 'center',
        baseline: 'top',
        shift: [0, 6],
      });
    }
    const names: [number, string][] = [
      [10, '10 Hz'],
      [1, '1 Hz'],
      [0.1, '10 s'],
      [0.01, '100 s'],
      [0.001, '17 min'],
      [0.0001, '3 h'],
    ];
    for (const [hertz, name] of names) {
      plane.line([X[0], log(hertz)], [X[1], log(hertz)], { colour: hairline, width: 1 });
      plane.text([X[0], log(hertz)], name, {
        colour: soft,
        size: 12,
        align: 'right',
        baseline: 'middle',
        shift: [-6, 0],
      });
    }
    const corner: Point[] = [
      [X[0], Y[1]],
      [X[0], Y[0]],
      [X[1], Y[0]],
    ];
    plane.polyline(corner, { colour: line, width: 1 });
    plane.text([X[1], Y[0]], 'length', { size: 12, align: 'right', baseline: 'top', shift: [0, 22] });
    plane.text([X[1], Y[1]], 'swings a second, or time of a swing', { size: 12, align: 'right', baseline: 'top' });
  }
}

/** Natural frequency by length and thickness. */
export const natural: FigureSpec = {
  id: 'natural',
  title: 'How fast a branch swings',
  aspect: 1.6,
  controls: [
    { id: 'length', label: 'Length L', unit: 'm', min: 0.1, max: 20, step: 0.1, value: 4 },
    { id: 'radius', label: 'Radius r', unit: 'cm', min: 0.2, max: 40, step: 0.1, value: 3 },
  ],
  readouts: [
    { id: 'ours', label: 'Ours swings', unit: 'Hz' },
    { id: 'rod', label: 'A bare rod', unit: 'Hz' },
    { id: 'printed', label: 'A swing as printed takes', unit: 's' },
  ],
  stage: (host) => new Natural(host),
};
