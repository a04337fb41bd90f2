import { generatorCubic } from '../../core/deform/generator.ts';
import { deform, surfacePoint } from '../../core/deform/surface.ts';
import { bezierDerivative, bezierPoint, bezierSecondDerivative, type Cubic, holdArc } from '../../core/math/bezier.ts';
import { handlesOf } from '../../core/math/frames.ts';
import { addScaled, cross, length, type Vec3 } from '../../core/math/vec3.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { DEGREE } from './example-branch.ts';

const O: Vec3 = [0, 0, -1];
const flat = (p: Vec3): Point => [p[0], p[1]];

/** A curve of a metre that bends by so many degrees at both joints, in a plane in which S lies. */
export const bow = (bend: number): Cubic => holdArc(generatorCubic(1, 0, bend * DEGREE, 0, bend * DEGREE), 1);

/** Half axes of the paper's section at u for a radius of 1: in the plane of the bend, and across it. */
export function halfAxes(bend: number, u: number): [inPlane: number, across: number] {
  const { byV, byW } = deform(bow(bend), handlesOf(bow(bend), O), u, 0, 0);
  return [length(byV), length(byW)];
}

/** 1 / radius of the circle that touches the curve at u. */
export function curvature(curve: Cubic, u: number): number {
  const d = bezierDerivative(curve, u);
  return length(cross(d, bezierSecondDerivative(curve, u))) / length(d) ** 3;
}

const STEPS = Array.from({ length: 81 }, (_, i) => i / 80);

export const SECTION_FIGURE: FigureSpec = {
  id: 'section',
  title: 'Sections in a bend',
  aspect: 1.7,
  controls: [
    { id: 'bend', label: 'Both joints', unit: '°', min: 0, max: 85, step: 1, value: 60 },
    { id: 'radius', label: 'Radius', unit: 'm', min: 0.02, max: 0.4, step: 0.01, value: 0.14 },
    { id: 'u', label: 'Along the branch, u', min: 0, max: 1, step: 0.01, value: 0.5 },
  ],
  readouts: [
    { id: 'inPlane', label: 'Paper’s width in the bend', unit: '%' },
    { id: 'across', label: 'Across it', unit: '%' },
    { id: 'fold', label: 'Radius × curvature' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const outlines = (values: Values) => {
      const curve = bow(numberOf(values, 'bend'));
      const handles = handlesOf(curve, O);
      const r = numberOf(values, 'radius');
      return {
        curve,
        exact: (u: number, side: number): Point => flat(surfacePoint(curve, handles, u, 0, side, r, 0, 0).position),
        paper: (u: number, side: number): Point => flat(deform(curve, handles, u, side * r, 0).position),
      };
    };
    return {
      draw(values) {
        plane.begin({ x: [-0.3, 1.08], y: [-0.26, 0.8], equal: true });
        const colours = host.colours();
        const { curve, exact, paper } = outlines(values);
        const [bend, u, r] = [numberOf(values, 'bend'), numberOf(values, 'u'), numberOf(values, 'radius')];
        const outer = STEPS.map((s) => exact(s, 1));
        const inner = STEPS.map((s) => exact(s, -1));
        plane.area([...outer, ...inner.toReversed()], { colour: colours.level1, alpha: 0.3 });
        for (let i = 0; i <= 80; i += 5) {
          plane.line(outer[i] as Point, inner[i] as Point, { colour: colours.level1, width: 1, alpha: 0.5 });
        }
        plane.polyline(
          STEPS.map((s) => flat(bezierPoint(curve, s))),
          { colour: colours.rest, width: 1.5, dash: [6, 4] },
        );
        for (const side of [-1, 1]) {
          plane.polyline(
            STEPS.map((s) => exact(s, side)),
            { colour: colours.answer, width: 2 },
          );
          plane.polyline(
            STEPS.map((s) => paper(s, side)),
            { colour: colours.wrong, width: 1.8, dash: [7, 4] },
          );
        }
        plane.line(exact(u, -1), exact(u, 1), { colour: colours.answer, width: 3 });
        plane.line(paper(u, -1), paper(u, 1), { colour: colours.wrong, width: 3, dash: [7, 4] });
        // The section itself, seen along the branch, in the corner that the branch leaves free.
        const [x0] = plane.x;
        const [, y1] = plane.y;
        const size = 0.15;
        const centre: Point = [x0 + 0.22, y1 - 0.24];
        const [inPlane, across] = halfAxes(bend, u);
        plane.circle(centre, size, { colour: colours.answer, width: 2 });
        plane.polyline(
          Array.from({ length: 73 }, (_, i): Point => {
            const angle = (i / 36) * Math.PI;
            return [centre[0] + size * across * Math.cos(angle), centre[1] + size * inPlane * Math.sin(angle)];
          }),
          { colour: colours.wrong, width: 2, dash: [7, 4] },
        );
        plane.text([centre[0], centre[1] - size], 'the section', {
          colour: colours.soft,
          size: 12,
          align: 'center',
          baseline: 'top',
          shift: [0, 8],
        });
        const fold = r * curvature(curve, u);
        return {
          inPlane: (100 * inPlane).toFixed(1),
          across: (100 * across).toFixed(1),
          fold: `${fold.toFixed(2)}${fold > 1 ? ', folds' : ''}`,
        };
      },
      handles(values) {
        const { curve, exact } = outlines(values);
        const u = numberOf(values, 'u');
        const middle = bezierPoint(curve, u);
        return [
          plane.handle({
            id: 'u',
            label: 'Place along the branch',
            at: flat(middle),
            colour: host.colours().rest,
            said: `u ${u}`,
            move: (x, y) => {
              const far = (s: number): number => length(addScaled([x, y, 0], bezierPoint(curve, s), -1));
              host.set(
                'u',
                STEPS.reduce((best, s) => (far(s) < far(best) ? s : best), 0),
              );
            },
          }),
          plane.handle({
            id: 'radius',
            label: 'Radius of the branch',
            at: exact(u, -1),
            colour: host.colours().answer,
            said: `${numberOf(values, 'radius')} metres`,
            move: (x, y) => host.set('radius', length(addScaled([x, y, 0], middle, -1))),
          }),
        ];
      },
      text(values) {
        const [inPlane, across] = halfAxes(numberOf(values, 'bend'), numberOf(values, 'u'));
        return `At u ${numberOf(values, 'u')} of a bend of twice ${numberOf(values, 'bend')} degrees the paper's section is ${(100 * inPlane).toFixed(0)} percent wide in the plane of the bend and ${(100 * across).toFixed(0)} percent across.`;
      },
    };
  },
};
