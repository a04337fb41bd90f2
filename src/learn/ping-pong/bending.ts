import { arcLength, bezierPoint, type Cubic } from '../../core/math/bezier.ts';
import { dot, length, subtract, unit, type Vec3 } from '../../core/math/vec3.ts';
import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { bentBranch, type StepForm, uprightBranch } from './printed-step.ts';

const flat = ([x, , z]: Vec3): Point => [x, z];
const LEAN = 0.07;
/** Metres of the sheet for a bend of 1. */
const REACH = 0.5;

const formOf = (values: Values): StepForm => {
  const form = choiceOf(values, 'form');
  return form === 'printed' || form === 'units' ? form : 'ours';
};

class Bending extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const plane = this.plane;
    const { rest: grey, answer, wrong, force, line, soft } = this.host.colours();
    const form = formOf(values);
    const b = numberOf(values, 'force');
    const rest = uprightBranch(numberOf(values, 'length'), LEAN);
    const bent = bentBranch(rest, [b, 0, 0], form);
    plane.begin({ x: [-1.1, 2.7], y: [-0.1, 2.7], equal: true });
    plane.grid(0.5, 0.5);
    plane.line([plane.x[0], 0], [plane.x[1], 0], { colour: line, width: 1 });
    for (const metre of [1, 2])
      plane.text([plane.x[0], metre], `${metre} m`, { colour: soft, size: 12, baseline: 'middle', shift: [4, 0] });
    this.#branch(rest, grey, 6, 0.7);
    const colour = form === 'ours' ? answer : wrong;
    this.#branch(bent, colour, 7, 1);
    this.#polygon(rest, grey);
    this.#polygon(bent, colour);
    const labels: [Vec3, string][] = [
      [bent.p0, 'P₀'],
      [bent.p1, 'P₁'],
      [bent.p2, 'P₂′'],
      [bent.p3, 'P₃′'],
    ];
    for (const [at, name] of labels) plane.text(flat(at), name, { italic: true, size: 15, colour, shift: [10, 14] });
    const tip = flat(rest.p3);
    plane.arrow(tip, [tip[0] + REACH * b, tip[1]], { colour: force, width: 4 });
    plane.text([tip[0] + REACH * b, tip[1]], 'b', { italic: true, size: 16, colour: force, shift: [12, -8] });
    const [before, after] = [arcLength(rest), arcLength(bent)];
    return {
      rest: before.toFixed(3),
      length: after.toFixed(3),
      error: signed((after / before - 1) * 100, 1),
      stretch: signed((arcLength(bentBranch(rest, [b, 0, 0], 'units')) / before - 1) * 100, 1),
      turn: turned(rest, bent).toFixed(1),
    };
  }

  handles(values: Values) {
    const host = this.host;
    const rest = uprightBranch(numberOf(values, 'length'), LEAN);
    const tip = flat(rest.p3);
    const b = numberOf(values, 'force');
    return [
      this.plane.handle({
        id: 'force',
        label: 'Force of the wind',
        at: [tip[0] + REACH * b, tip[1]],
        ways: 'across',
        colour: host.colours().force,
        said: `a bend of ${b}`,
        move: (x) => host.set('force', (x - tip[0]) / REACH),
      }),
      this.plane.handle({
        id: 'length',
        label: 'Tip of the branch at rest',
        at: [tip[0], tip[1] + (b === 0 ? 0.12 : 0)],
        ways: 'up',
        colour: host.colours().rest,
        said: `${numberOf(values, 'length')} metres long`,
        move: (_, y) => host.set('length', y / (tip[1] / numberOf(values, 'length'))),
      }),
    ];
  }

  text(values: Values): string {
    const rest = uprightBranch(numberOf(values, 'length'), LEAN);
    const bent = bentBranch(rest, [numberOf(values, 'force'), 0, 0], formOf(values));
    return `A branch of ${arcLength(rest).toFixed(2)} metres is ${arcLength(bent).toFixed(2)} metres long in the wind.`;
  }

  #branch(curve: Cubic, colour: string, width: number, alpha: number): void {
    // Tapering: the last part is the thinnest.
    for (let i = 0; i < 40; i++) {
      const [a, b] = [bezierPoint(curve, i / 40), bezierPoint(curve, (i + 1.2) / 40)];
      this.plane.line(flat(a), flat(b), { colour, width: width * (1 - (0.75 * i) / 40), alpha });
    }
  }

  #polygon({ p0, p1, p2, p3 }: Cubic, colour: string): void {
    this.plane.polyline([p0, p1, p2, p3].map(flat), { colour, width: 1, dash: [4, 4] });
    for (const p of [p0, p1, p2, p3]) this.plane.dot(flat(p), 3.5, { colour });
  }
}

/** Degrees between the last edges of two curves. */
function turned(a: Cubic, b: Cubic): number {
  const last = ({ p2, p3 }: Cubic): Vec3 => subtract(p3, p2);
  const [x, y] = [last(a), last(b)];
  if (length(x) === 0 || length(y) === 0) return 0;
  return (Math.acos(Math.min(1, Math.max(-1, dot(unit(x), unit(y))))) * 180) / Math.PI;
}

/** The paper's figure 5, equation 17: as printed, with its units repaired, and length-preserving. */
export const bending: FigureSpec = {
  id: 'bending',
  title: 'One bending step',
  aspect: 1.45,
  controls: [
    {
      id: 'form',
      label: 'Form',
      value: 'printed',
      options: [
        { value: 'printed', label: 'As printed' },
        { value: 'units', label: 'Units repaired' },
        { value: 'ours', label: 'Length kept' },
      ],
    },
    { id: 'force', label: 'Bend b', min: 0, max: 3, step: 0.05, value: 0.7 },
    { id: 'length', label: 'Length at rest', unit: 'm', min: 0.3, max: 2.4, step: 0.05, value: 1.2 },
  ],
  readouts: [
    { id: 'rest', label: 'Length at rest', unit: 'm' },
    { id: 'length', label: 'Length in the wind', unit: 'm' },
    { id: 'error', label: 'Error of the length', unit: '%' },
    { id: 'turn', label: 'The last edge has turned', unit: '°' },
  ],
  stage: (host) => new Bending(host),
};
