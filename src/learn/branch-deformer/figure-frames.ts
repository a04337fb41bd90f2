import { generatorCubic } from '../../core/deform/generator.ts';
import { surfacePoint } from '../../core/deform/surface.ts';
import { type Cubic, holdArc } from '../../core/math/bezier.ts';
import { type Handles, handlesOf, projectedHandlesOf } from '../../core/math/frames.ts';
import { add, addScaled, cross, dot, mix, scale, type Vec3 } from '../../core/math/vec3.ts';
import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane } from '../plane.ts';
import { signed } from '../signed.ts';
import { rowsOf } from './branch-mesh.ts';
import { DEGREE, PARENT } from './example-branch.ts';
import { Orbit } from './orbit.ts';
import { fixedUpHandles } from './printed.ts';
import { type Eye, projector } from './solid.ts';
import { barkTones, lightFrom, lightOn, paintRows } from './surface-picture.ts';

const LENGTH = 2;
const RADIUS = 0.075;

const WAYS: Readonly<Record<string, (curve: Cubic) => Handles>> = {
  transport: (curve) => handlesOf(curve, PARENT),
  sloan: (curve) => projectedHandlesOf(curve, PARENT),
  fixed: (curve) => fixedUpHandles(curve, PARENT),
};

const curveOf = (bend: number, direction: number): Cubic =>
  holdArc(generatorCubic(LENGTH, direction * DEGREE, bend * DEGREE, 0, bend * 0.5 * DEGREE), LENGTH);

/** Degrees by which a way of making handles has turned each of the last two about its edge, beside parallel transport. */
export function turnedBy(way: string, bend: number, direction: number): [first: number, second: number] {
  const curve = curveOf(bend, direction);
  const right = handlesOf(curve, PARENT);
  const other = (WAYS[way] as (curve: Cubic) => Handles)(curve);
  const angle = (a: Vec3, b: Vec3, about: Vec3): number => Math.atan2(dot(cross(a, b), about), dot(a, b)) / DEGREE;
  return [angle(right.t1, other.t1, right.l1), angle(right.t2, other.t2, right.l2)];
}

const found = (values: Values): [string, number, number] => [
  choiceOf(values, 'way'),
  numberOf(values, 'bend'),
  numberOf(values, 'direction'),
];

export const FRAMES_FIGURE: FigureSpec = {
  id: 'frames',
  title: 'A stripe along the bark',
  aspect: 1.6,
  controls: [
    {
      id: 'way',
      label: 'Sideways by',
      options: [
        { value: 'transport', label: 'transport' },
        { value: 'sloan', label: 'Sloan' },
        { value: 'fixed', label: 'fixed direction' },
      ],
      value: 'sloan',
    },
    { id: 'bend', label: 'First joint', unit: '°', min: 0, max: 130, step: 1, value: 75 },
    { id: 'direction', label: 'Direction of the bend', unit: '°', min: -180, max: 180, step: 1, value: 35 },
  ],
  readouts: [
    { id: 'first', label: 'Twisted at the first joint', unit: '°' },
    { id: 'second', label: 'After the second', unit: '°' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const orbit = new Orbit(host, -0.5, 0.45);
    const eyeOn = ({ p0, p1, p2, p3 }: Cubic): Eye => {
      const { width, height } = host.size;
      const scale = Math.min(width / 2.7, height / 1.9);
      return {
        ...orbit.angles,
        scale,
        centre: mix(mix(p0, p3, 0.5), mix(p1, p2, 0.5), 0.4),
        x: width / 2,
        y: height / 2,
      };
    };
    return {
      reset: () => orbit.reset(),
      draw(values) {
        plane.begin({ x: [0, 1], y: [0, 1] });
        const { context } = plane;
        const colours = host.colours();
        const [way, bend, direction] = found(values);
        const curve = curveOf(bend, direction);
        const handles = (WAYS[way] as (curve: Cubic) => Handles)(curve);
        const eye = eyeOn(curve);
        const rows = rowsOf(24, 60, (u, turns) => {
          const angle = 2 * Math.PI * turns;
          return surfacePoint(
            curve,
            handles,
            u,
            Math.cos(angle),
            Math.sin(angle),
            RADIUS * (1 - 0.55 * u),
            -0.55 * RADIUS,
            0,
          );
        });
        const tone = barkTones(colours);
        const light = lightFrom(eye);
        paintRows(context, rows, eye, colours, {
          tint(cell) {
            const [first] = cell;
            if (!first) return colours.ink;
            // Two sectors of twenty-four, one each side of theta = 0.
            const turns = (cell.reduce((sum, point) => sum + point.turns, 0) / 4 + 0.5) % 1;
            if (Math.abs(turns - 0.5) < 0.043) return colours.answer;
            return tone(lightOn(dot(first.normal, light)));
          },
        });
        const project = projector(eye);
        const px = (p: Vec3): [number, number] => {
          const [x, y] = project(p);
          return plane.toWorld(x, y) as [number, number];
        };
        const corners = [curve.p0, curve.p1, curve.p2, curve.p3] as const;
        plane.polyline(corners.map(px), { colour: colours.rest, width: 1.5, dash: [6, 4] });
        const edges = [
          [handles.l0, handles.t0],
          [handles.l1, handles.t1],
          [handles.l2, handles.t2],
        ] as const;
        edges.forEach(([l, t], i) => {
          const middle = mix(corners[i] as Vec3, corners[i + 1] as Vec3, 0.5);
          const to = (way: Vec3, long: number): [number, number] => px(addScaled(middle, way, long));
          plane.arrow(px(middle), to(l, 0.22), { colour: colours.velocity, width: 2 });
          plane.arrow(px(middle), to(cross(l, t), 0.3), { colour: colours.answer, width: 1.5, alpha: 0.75 });
          plane.arrow(px(middle), to(t, 0.36), { colour: colours.answer, width: 2.5 });
          const label = add(middle, scale(t, 0.42));
          plane.text(px(label), `T${'₀₁₂'[i]}`, {
            colour: colours.answer,
            size: 12,
            align: 'center',
            baseline: 'middle',
          });
          plane.text(to(cross(l, t), 0.37), `S${'₀₁₂'[i]}`, {
            colour: colours.answer,
            size: 12,
            align: 'center',
            baseline: 'middle',
          });
          plane.dot(px(corners[i + 1] as Vec3), 3.5, { colour: colours.rest });
        });
        const [first, second] = turnedBy(way, bend, direction);
        return { first: signed(first, 1), second: signed(second, 1) };
      },
      text(values) {
        const [way, bend, direction] = found(values);
        const [first, second] = turnedBy(way, bend, direction);
        return `Joints of ${bend} and ${bend / 2} degrees in the direction ${direction}: the stripe is twisted by ${first.toFixed(0)} and ${second.toFixed(0)} degrees.`;
      },
    };
  },
};
