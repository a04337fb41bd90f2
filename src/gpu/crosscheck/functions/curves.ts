import bezierFragment from '../../../../shaders/debug/check-bezier.frag';
import frameFragment from '../../../../shaders/debug/check-frame.frag';
import handlesFragment from '../../../../shaders/debug/check-handles.frag';
import {
  arcLength,
  bezierDerivative,
  bezierPoint,
  bezierSecondDerivative,
  holdArc,
} from '../../../core/math/bezier.ts';
import { type Handles, handlesOf, projectedHandlesOf, sectionFrame, transport } from '../../../core/math/frames.ts';
import { cross, unit, type Vec3 } from '../../../core/math/vec3.ts';
import type { CheckProgram } from '../program.ts';
import { between, direction, near } from '../random.ts';
import {
  curveInput,
  curveOf,
  curveSize,
  degenerateCurves,
  framedCurve,
  orientationOf,
  randomCurve,
} from './curve-inputs.ts';

const METRES = 'of the branch’s size';

const bezier: CheckProgram = {
  name: 'bezier',
  fragment: bezierFragment,
  layers: 4,
  edges: degenerateCurves.flatMap((curve) => [0, 0.5, 1].map((u) => curveInput(curve, [u, 1.1]))),
  inputs: (random) => curveInput(randomCurve(random), [random(), between(random, 0.01, 6)]),
  twin: (given) => {
    const curve = curveOf(given);
    const [u, rest] = [given[3], given[7]];
    return [
      ...bezierPoint(curve, u),
      arcLength(curve),
      ...bezierDerivative(curve, u),
      0,
      ...bezierSecondDerivative(curve, u),
      0,
      ...holdArc(curve, rest).p3,
      0,
    ];
  },
  size: (given) => Math.max(curveSize(curveOf(given)), given[7]),
  lines: [
    { name: 'bezierPoint', parts: [0, 1, 2], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'arcLength', parts: [3], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'bezierDerivative', parts: [4, 5, 6], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'bezierSecondDerivative', parts: [8, 9, 10], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'holdArc', parts: [12, 13, 14], bySize: true, tolerance: 2e-5, note: METRES },
  ],
};

const ANGLE = 'radians';

/** Degenerate curves at three places, with O across and with O along the first edge. */
const framedEdges = degenerateCurves.flatMap((curve) =>
  [0, 0.5, 1].flatMap((u) => [curveInput(curve, [u, 0, 1, 0]), curveInput(curve, [u, 0, 0, 1])]),
);

const handleResults = ({ l0, l1, l2, t0, t1, t2 }: Handles): number[] => [
  ...l0,
  l1[0],
  ...t0,
  l1[1],
  ...t1,
  l1[2],
  ...t2,
  l2[0],
];

const handles: CheckProgram = {
  name: 'handles',
  fragment: handlesFragment,
  layers: 4,
  edges: framedEdges,
  inputs: (random) => framedCurve(random, 1.5),
  twin: (given) => handleResults(handlesOf(curveOf(given), orientationOf(given))),
  lines: [
    { name: 'edgesOf', parts: [0, 1, 2, 3, 7, 11, 15], tolerance: 2e-5, note: 'of 1' },
    { name: 'handlesOf', parts: [4, 5, 6, 8, 9, 10, 12, 13, 14], tolerance: 1e-4, note: ANGLE },
  ],
};

const projected: CheckProgram = {
  name: 'projected handles',
  fragment: handlesFragment,
  defines: { PROJECTED: 1 },
  layers: 4,
  edges: framedEdges,
  // Beyond 60 degrees equation 8's projection grows singular: any rounding is enlarged without bound.
  inputs: (random) => framedCurve(random, 1),
  twin: (given) => handleResults(projectedHandlesOf(curveOf(given), orientationOf(given))),
  lines: [{ name: 'projectedHandlesOf', parts: [4, 5, 6, 8, 9, 10, 12, 13, 14], tolerance: 1e-4, note: ANGLE }],
};

const frame: CheckProgram = {
  name: 'frame',
  fragment: frameFragment,
  layers: 7,
  edges: framedEdges.map((edge) => [...edge, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]),
  inputs: (random) => {
    const p = direction(random);
    const a = unit(cross(p, direction(random)));
    return [...framedCurve(random, 1.5), ...a, 0, ...p, 0, ...near(random, p, 1.5), 0];
  },
  twin: (given) => {
    const curve = curveOf(given);
    const [u, t, s] = sectionFrame(curve, handlesOf(curve, orientationOf(given)), given[3]);
    const vector = (layer: number) => given.slice(4 * layer, 4 * layer + 3) as Vec3;
    return [...u, 0, ...t, 0, ...s, 0, ...transport(vector(4), vector(5), vector(6)), 0];
  },
  lines: [
    { name: 'tangentAt', parts: [0, 1, 2], error: 'vector', tolerance: 1e-4, note: ANGLE },
    { name: 'sectionFrame', parts: [4, 5, 6, 8, 9, 10], tolerance: 1e-4, note: ANGLE },
    { name: 'transport', parts: [12, 13, 14], error: 'vector', tolerance: 1e-4, note: ANGLE },
  ],
};

/** The functions on curves and their frames. */
export const curvePrograms: readonly CheckProgram[] = [bezier, handles, projected, frame];
