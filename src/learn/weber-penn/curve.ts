import { curveDeltas, stemPolyline } from '../../core/grow/curve.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { printedDeltas } from './printed.ts';

const LENGTH = 4;
const RADIANS = Math.PI / 180;

const sum = (list: readonly number[]): number => list.reduce((a, b) => a + b, 0);

/** A stem in its own plane: it begins upwards, and a positive curve bends it to the right. */
const course = (deltas: readonly number[]): Point[] =>
  stemPolyline(
    LENGTH,
    deltas.map((delta) => delta * RADIANS),
  ).map(([, y, z]) => [-y, z]);

/** The whole degrees of nCurve that bring the tip nearest to a point. */
function nearestCurve(x: number, y: number, back: number, res: number): number {
  let best = 0;
  let least = Number.POSITIVE_INFINITY;
  for (let degrees = -150; degrees <= 150; degrees++) {
    const [tx, ty] = course(curveDeltas(degrees, back, res)).at(-1) as Point;
    const away = Math.hypot(tx - x, ty - y);
    if (away < least) [least, best] = [away, degrees];
  }
  return best;
}

class Curve extends PlaneFigure {
  #tip: Point = [0, LENGTH];

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    const [curve, back, res] = ['curve', 'back', 'res'].map((id) => numberOf(values, id)) as [number, number, number];
    p.begin({ x: [-3.4, 3.4], y: [-0.9, 4.3], equal: true });
    p.line([0, p.y[0]], [0, p.y[1]], { colour: c.hairline, width: 1, dash: [4, 4] });
    const ours = curveDeltas(curve, back, res);
    const theirs = printedDeltas(curve, back, res);
    const differ = Math.abs(sum(ours) - sum(theirs)) > 0.05;
    if (differ) p.polyline(course(theirs), { colour: c.wrong, width: 2, dash: [7, 5] });
    const nodes = course(ours);
    p.polyline(nodes, { colour: c.level1, width: 7 });
    nodes.forEach((node, i) => {
      p.dot(node, 4, { colour: c.paper });
      p.dot(node, 2.5, { colour: c.level0 });
      if (i < res && res <= 8) p.text(node, `${ours[i]!.toFixed(0)}°`, { shift: [12, 4], size: 12, colour: c.answer });
    });
    this.#tip = nodes.at(-1) as Point;
    if (differ) p.text(course(theirs).at(-1) as Point, 'as printed', { colour: c.wrong, shift: [10, 4], size: 12 });
    return { ours: sum(ours).toFixed(1), theirs: sum(theirs).toFixed(1) };
  }

  handles(values: Values) {
    return [
      this.plane.handle({
        id: 'tip',
        label: 'Tip of the stem, sets nCurve',
        step: 12,
        at: this.#tip,
        colour: this.host.colours().answer,
        move: (x, y) => this.host.set('curve', nearestCurve(x, y, numberOf(values, 'back'), numberOf(values, 'res'))),
      }),
    ];
  }

  text(values: Values): string {
    return `A stem of ${numberOf(values, 'res')} segments that turns by ${numberOf(values, 'curve')} degrees in all${numberOf(values, 'back') ? ` in its first half and by ${numberOf(values, 'back')} in its second` : ''}.`;
  }
}

/** 4.1: the course of a stem. */
export const curve: FigureSpec = {
  id: 'curve',
  title: 'Curve and curve back',
  aspect: 1.35,
  controls: [
    { id: 'curve', label: 'nCurve', unit: '°', min: -150, max: 150, step: 1, value: 40 },
    { id: 'back', label: 'nCurveBack', unit: '°', min: -150, max: 150, step: 1, value: 80 },
    { id: 'res', label: 'nCurveRes', min: 1, max: 16, step: 1, value: 3 },
  ],
  readouts: [
    { id: 'ours', label: 'Turn in all', unit: '°' },
    { id: 'theirs', label: 'Halves read literally', unit: '°' },
  ],
  stage: (host) => new Curve(host),
};
