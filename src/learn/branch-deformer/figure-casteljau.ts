import { generatorCubic } from '../../core/deform/generator.ts';
import { deform } from '../../core/deform/surface.ts';
import { handlesOf } from '../../core/math/frames.ts';
import { mix, type Vec3 } from '../../core/math/vec3.ts';
import { choiceOf, type FigureSpec, numberOf } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { signed } from '../signed.ts';
import { DEGREE } from './example-branch.ts';
import { construction } from './printed.ts';

// In a plane: S lies in it, T stands on it.
const CURVE = generatorCubic(1.2, 0, 62 * DEGREE, 0, -48 * DEGREE);
const HANDLES = handlesOf(CURVE, [0, 0, -1]);
const flat = (p: Vec3): Point => [p[0], p[1]];
const at = (u: number, v: number, printed: boolean): Vec3 => construction(CURVE, HANDLES, u, v, 0, printed).point;

export const CASTELJAU_FIGURE: FigureSpec = {
  id: 'casteljau',
  title: 'A point beside the curve',
  aspect: 1.7,
  controls: [
    { id: 'u', label: 'Along the curve, u', min: 0, max: 1, step: 0.01, value: 0.44 },
    { id: 'v', label: 'Beside it, v', unit: 'm', min: -0.3, max: 0.3, step: 0.01, value: 0.16 },
    {
      id: 'form',
      label: 'Last line',
      options: [
        { value: 'right', label: 'as in 2006' },
        { value: 'printed', label: 'as printed in 2007' },
      ],
      value: 'right',
    },
  ],
  readouts: [
    { id: 'x', label: 'The point, x', unit: 'm' },
    { id: 'y', label: 'y', unit: 'm' },
    { id: 'off', label: 'From where it belongs', unit: 'm' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    return {
      draw(values) {
        plane.begin({ x: [-0.06, 1.0], y: [-0.26, 0.6], equal: true });
        const colours = host.colours();
        const [u, v] = [numberOf(values, 'u'), numberOf(values, 'v')];
        const printed = choiceOf(values, 'form') === 'printed';
        const corners = [CURVE.p0, CURVE.p1, CURVE.p2, CURVE.p3] as const;
        const steps = Array.from({ length: 81 }, (_, i) => i / 80);
        const along = (beside: number, wrong: boolean): Point[] => steps.map((s) => flat(at(s, beside, wrong)));
        // The strip that the branch would fill, so that one sees what is bent.
        plane.area([...along(v, false), ...along(-v, false).toReversed()], { colour: colours.level1, alpha: 0.18 });
        plane.polyline(corners.map(flat), { colour: colours.rest, width: 1.5, dash: [6, 4] });
        plane.polyline(along(0, false), { colour: colours.rest, width: 2 });
        plane.polyline(along(v, false), { colour: colours.answer, width: 2, ...(printed ? { dash: [3, 4] } : {}) });
        if (printed) plane.polyline(along(v, true), { colour: colours.wrong, width: 2, dash: [9, 5] });
        const { edges, pair, point } = construction(CURVE, HANDLES, u, v, 0, printed);
        edges.forEach((end, i) => {
          const start = mix(corners[i] as Vec3, corners[i + 1] as Vec3, u);
          plane.dot(flat(start), 3.5, { colour: colours.rest });
          plane.arrow(flat(start), flat(end), { colour: colours.answer, width: 2 });
          plane.text(flat(mix(start, end, 0.5)), `S${'₀₁₂'[i]} v`, {
            colour: colours.answer,
            size: 12,
            baseline: 'middle',
            shift: [8, 0],
          });
        });
        plane.polyline(edges.map(flat), { colour: colours.soft, width: 1 });
        plane.polyline(pair.map(flat), { colour: colours.ink, width: 1.5 });
        for (const end of edges) plane.dot(flat(end), 3.5, { colour: colours.answer });
        for (const end of pair) plane.dot(flat(end), 3.5, { colour: colours.ink });
        if (printed) plane.line(flat(edges[1]), flat(pair[1]), { colour: colours.wrong, width: 2 });
        ['P₀', 'P₁', 'P₂', 'P₃'].forEach((name, i) => {
          plane.dot(flat(corners[i] as Vec3), 4, { colour: colours.rest });
          plane.text(flat(corners[i] as Vec3), name, {
            colour: colours.soft,
            size: 12,
            align: 'center',
            shift: [0, 20],
          });
        });
        const { position } = deform(CURVE, HANDLES, u, v, 0);
        return {
          x: signed(point[0], 3),
          y: signed(point[1], 3),
          off: Math.hypot(point[0] - position[0], point[1] - position[1]).toFixed(3),
        };
      },
      handles(values) {
        const [u, v] = [numberOf(values, 'u'), numberOf(values, 'v')];
        const printed = choiceOf(values, 'form') === 'printed';
        return [
          plane.handle({
            id: 'point',
            label: 'The deformed point',
            at: flat(at(u, v, printed)),
            colour: printed ? host.colours().wrong : host.colours().answer,
            said: `u ${u}, v ${v} metres`,
            move(x, y) {
              // Where the pointer is, on the line across the curve at each u; the nearest of these.
              let best = { u, v, far: Number.POSITIVE_INFINITY };
              for (let i = 0; i <= 100; i++) {
                const [c, d] = [at(i / 100, 0, printed), at(i / 100, 1, printed)];
                const s: Point = [d[0] - c[0], d[1] - c[1]];
                const raw = ((x - c[0]) * s[0] + (y - c[1]) * s[1]) / (s[0] ** 2 + s[1] ** 2);
                const beside = Math.min(0.3, Math.max(-0.3, raw));
                const far = Math.hypot(x - c[0] - s[0] * beside, y - c[1] - s[1] * beside);
                if (far < best.far - 1e-9) best = { u: i / 100, v: beside, far };
              }
              host.set('u', best.u);
              host.set('v', best.v);
            },
          }),
        ];
      },
      text(values) {
        const [x, y] = at(numberOf(values, 'u'), numberOf(values, 'v'), choiceOf(values, 'form') === 'printed');
        return `At u ${numberOf(values, 'u')} and ${numberOf(values, 'v')} metres beside the curve, the point is at ${x.toFixed(2)}, ${y.toFixed(2)}.`;
      },
    };
  },
};
