import { attractAsPrinted, attractUp, curveUp, declinationOf } from '../../core/grow/attraction.ts';
import { type Frame, newFrame, turnX } from '../../core/grow/frame.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';

const LENGTH = 4;
const DEGREES = 180 / Math.PI;

/** One stem that begins at `start` degrees from the vertical and turns before each of its segments. */
function course(
  start: number,
  segments: number,
  turn: (f: Frame, left: number) => void,
): { nodes: Point[]; end: number } {
  const f = newFrame();
  turnX(f, start / DEGREES);
  const nodes: Point[] = [[0, 0]];
  for (let i = 0; i < segments; i++) {
    turn(f, segments - i);
    const [x, z] = nodes.at(-1) as Point;
    nodes.push([x - (LENGTH / segments) * f[7]!, z + (LENGTH / segments) * f[8]!]);
  }
  return { nodes, end: declinationOf(f) * DEGREES };
}

class Attraction extends PlaneFigure {
  #courses(values: Values) {
    const [pull, start, segments] = ['pull', 'start', 'segments'].map((id) => numberOf(values, id)) as [
      number,
      number,
      number,
    ];
    return {
      ours: course(start, segments, (f, left) => attractUp(f, pull, left, 0)),
      mended: course(start, segments, (f) => attractAsPrinted(f, pull, segments)),
      literal: course(start, segments, (f) => turnX(f, curveUp(f, pull, segments))),
    };
  }

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-1.2, 4.6], y: [-2.8, 3.4], equal: true });
    p.line([0, p.y[0]], [0, p.y[1]], { colour: c.hairline, width: 1, dash: [4, 4] });
    const { ours, mended, literal } = this.#courses(values);
    const branch = (
      nodes: readonly Point[],
      colour: string,
      name: string,
      dash: readonly number[],
      width: number,
    ): void => {
      p.polyline(nodes, { colour, width, dash });
      p.text(nodes.at(-1) as Point, name, { colour, shift: [10, 4], size: 12 });
    };
    branch(literal.nodes, c.wrong, 'as printed', [7, 5], 2);
    branch(mended.nodes, c.rest, 'with the sign mended', [3, 4], 2);
    branch(ours.nodes, c.answer, 'ours', [], 5);
    const start = numberOf(values, 'start') / DEGREES;
    p.arrow([0, 0], [0.9 * Math.sin(start), 0.9 * Math.cos(start)], { colour: c.force });
    return { ours: ours.end.toFixed(1), mended: mended.end.toFixed(1), literal: literal.end.toFixed(1) };
  }

  handles(values: Values) {
    const start = numberOf(values, 'start') / DEGREES;
    return [
      this.plane.handle({
        id: 'start',
        label: 'Direction in which the stem begins',
        at: [0.9 * Math.sin(start), 0.9 * Math.cos(start)],
        colour: this.host.colours().force,
        said: `${numberOf(values, 'start')} degrees from the vertical`,
        move: (x, y) => this.host.set('start', Math.atan2(Math.max(0, x), y) * DEGREES),
        // To the right and up is nearer to the vertical: as the tip goes when it is dragged.
        turn: (steps) => this.host.set('start', numberOf(values, 'start') - steps),
      }),
    ];
  }

  text(values: Values): string {
    const { ours, literal } = this.#courses(values);
    return `With an attraction of ${numberOf(values, 'pull')} a stem that begins ${numberOf(values, 'start')} degrees from the vertical ends ${ours.end.toFixed(0)} degrees from it; as printed, ${literal.end.toFixed(0)}.`;
  }
}

/** 4.8: up to the light, or down. */
export const attraction: FigureSpec = {
  id: 'attraction',
  title: 'Attraction to the light',
  aspect: 1.2,
  controls: [
    { id: 'pull', label: 'AttractionUp', min: -3, max: 3, step: 0.1, value: 1 },
    { id: 'start', label: 'Begins at', unit: '°', min: 1, max: 150, step: 1, value: 90 },
    { id: 'segments', label: 'nCurveRes', min: 1, max: 30, step: 1, value: 10 },
  ],
  readouts: [
    { id: 'ours', label: 'Ours ends at', unit: '°' },
    { id: 'mended', label: 'Printed, sign mended', unit: '°' },
    { id: 'literal', label: 'As printed', unit: '°' },
  ],
  stage: (host) => new Attraction(host),
};
