import { generatorCubic } from '../../core/deform/generator.ts';
import { arcLength, bezierPoint, holdArc } from '../../core/math/bezier.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import { type FigureSpec, numberOf, switchOf, type Values } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { DEGREE } from './example-branch.ts';

const flat = (p: Vec3): Point => [p[0], p[1]];
const plain = (values: Values) =>
  generatorCubic(1, 0, numberOf(values, 'b1') * DEGREE, 0, numberOf(values, 'b2') * DEGREE);

/** By what the edges of the walk must grow for the curve to be as long as the branch. */
export const missingFactor = (b1: number, b2: number): number =>
  1 / arcLength(generatorCubic(1, 0, b1 * DEGREE, 0, b2 * DEGREE));

export const WALK_FIGURE: FigureSpec = {
  id: 'walk',
  title: 'Three steps make four points',
  aspect: 1.6,
  controls: [
    { id: 'b1', label: 'First joint', unit: '°', min: -90, max: 90, step: 1, value: 55 },
    { id: 'b2', label: 'Second joint', unit: '°', min: -90, max: 90, step: 1, value: 35 },
    { id: 'keep', label: 'Keep the length', value: false },
  ],
  readouts: [
    { id: 'arc', label: 'Length of the curve', unit: 'L' },
    { id: 'factor', label: 'Edges to be multiplied by' },
    { id: 'edge', label: 'Length of an edge', unit: 'L' },
  ],
  open: (values) => `s=quaking-aspen&seed=1&leaves=0&levels.1.curve=${numberOf(values, 'b1') + numberOf(values, 'b2')}`,
  stage: (host) => {
    const plane = new Plane(host);
    const curveOf = (values: Values) => (switchOf(values, 'keep') ? holdArc(plain(values), 1) : plain(values));
    return {
      draw(values) {
        plane.begin({ x: [-0.12, 1.12], y: [-0.42, 0.72], equal: true });
        const colours = host.colours();
        const curve = curveOf(values);
        const corners = [curve.p0, curve.p1, curve.p2, curve.p3].map(flat) as [Point, Point, Point, Point];
        plane.grid(0.2, 0.2);
        plane.polyline(corners, { colour: colours.rest, width: 1.5, dash: [6, 4] });
        // Straight on, from which the joint turns.
        const bends = [numberOf(values, 'b1'), numberOf(values, 'b2')] as const;
        bends.forEach((bend, i) => {
          const [from, joint] = [corners[i] as Point, corners[i + 1] as Point];
          const long = Math.hypot(joint[0] - from[0], joint[1] - from[1]);
          const way = Math.atan2(joint[1] - from[1], joint[0] - from[0]);
          const end: Point = [joint[0] + (joint[0] - from[0]) * 0.5, joint[1] + (joint[1] - from[1]) * 0.5];
          plane.line(joint, end, { colour: colours.line, width: 1, dash: [2, 4] });
          const arc = Array.from({ length: 21 }, (_, k): Point => {
            const angle = way + (bend * DEGREE * k) / 20;
            return [joint[0] + 0.36 * long * Math.cos(angle), joint[1] + 0.36 * long * Math.sin(angle)];
          });
          plane.polyline(arc, { colour: colours.velocity, width: 2 });
          const middle = way + (bend * DEGREE) / 2;
          plane.text(
            [joint[0] + 0.56 * long * Math.cos(middle), joint[1] + 0.56 * long * Math.sin(middle)],
            `${bend}°`,
            {
              colour: colours.velocity,
              align: 'center',
              baseline: 'middle',
            },
          );
        });
        const points = Array.from({ length: 61 }, (_, i) => flat(bezierPoint(curve, i / 60)));
        plane.polyline(points, { colour: colours.level0, width: 5, alpha: 0.9 });
        ['P₀', 'P₁', 'P₂', 'P₃'].forEach((name, i) => {
          plane.dot(corners[i] as Point, 4, { colour: colours.rest });
          plane.text(corners[i] as Point, name, {
            colour: colours.soft,
            align: 'center',
            baseline: 'top',
            shift: [0, 14],
          });
        });
        const factor = missingFactor(...bends);
        return {
          arc: arcLength(curve).toFixed(4),
          factor: factor.toFixed(3),
          edge: ((switchOf(values, 'keep') ? factor : 1) / 3).toFixed(3),
        };
      },
      handles(values) {
        const curve = curveOf(values);
        const turn = (x: number, y: number, from: Vec3, way: number): number => {
          const angle = Math.atan2(y - from[1], x - from[0]) - way;
          return Math.atan2(Math.sin(angle), Math.cos(angle)) / DEGREE;
        };
        const way = Math.atan2(curve.p2[1] - curve.p1[1], curve.p2[0] - curve.p1[0]);
        const { rest } = host.colours();
        return [
          plane.handle({
            id: 'p2',
            label: 'Third control point',
            at: flat(curve.p2),
            colour: rest,
            said: `first joint ${numberOf(values, 'b1')} degrees`,
            move: (x, y) => host.set('b1', turn(x, y, curve.p1, 0)),
          }),
          plane.handle({
            id: 'p3',
            label: 'Last control point',
            at: flat(curve.p3),
            colour: rest,
            said: `second joint ${numberOf(values, 'b2')} degrees`,
            move: (x, y) => host.set('b2', turn(x, y, curve.p2, way)),
          }),
        ];
      },
      text: (values) =>
        `Joints of ${numberOf(values, 'b1')} and ${numberOf(values, 'b2')} degrees; the curve is ${arcLength(curveOf(values)).toFixed(3)} of the branch's length.`,
    };
  },
};
