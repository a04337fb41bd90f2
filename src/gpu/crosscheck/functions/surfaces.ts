import radiusFragment from '../../../../shaders/debug/check-radius.frag';
import surfaceFragment from '../../../../shaders/debug/check-surface.frag';
import {
  bulges,
  clampedFlare,
  flare,
  lobes,
  powerTaper,
  type Shape,
  stemRadius,
  taperRadius,
} from '../../../core/deform/radius.ts';
import { paperSurfacePoint, type SurfacePoint, surfacePoint } from '../../../core/deform/surface.ts';
import { handlesOf } from '../../../core/math/frames.ts';
import { cosTurns, sinTurns } from '../../../core/math/trig.ts';
import type { Line } from '../compare.ts';
import type { CheckProgram } from '../program.ts';
import { between, magnitude, type Random } from '../random.ts';
import { curveInput, curveOf, curveSize, degenerateCurves, framedCurve, orientationOf } from './curve-inputs.ts';

const METRES = 'of the branch’s size';
const ANGLE = 'radians';

const shapeOf = (g: readonly number[]): Shape => ({
  taper: g[4],
  flare: g[5],
  bulges: g[6],
  bulgeDepth: g[7],
  lobes: g[8],
  lobeDepth: g[9],
  lobeFade: g[10],
});

/** Foot, tip and middle of stems of one taper, smooth, with everything on them, and without radius. */
const taperEdges = (taper: number): number[][] =>
  [0, 0.125, 0.5, 1].flatMap((z) => [
    [z, 0, 0.1, 4, taper, 0, 0, 0, 0, 0, 0, 1],
    [z, 0.3, 0.1, 4, taper, 0.6, 3, 0.1, 5, 0.2, 0.7, 0.5],
    [z, 0.3, 0, 1, taper, 0.6, 0, 0, 0, 0, 0, 0],
  ]);

const radius: CheckProgram = {
  name: 'radius',
  fragment: radiusFragment,
  layers: 3,
  edges: [0, 0.5, 1, 1.5, 2].flatMap(taperEdges),
  inputs: (random) => {
    const length = magnitude(random, 0.05, 30);
    return [
      random(),
      random(),
      length * magnitude(random, 1 / 500, 1 / 10),
      length,
      2 * random(),
      random() < 0.5 ? 0 : 1.5 * random(),
      Math.floor(8 * random()),
      0.3 * random(),
      Math.floor(9 * random()),
      0.4 * random(),
      random(),
      magnitude(random, 0.3, 4),
    ];
  },
  twin: (g) => {
    const [z, turns, r, length] = g;
    const [value, byZ, byAngle] = lobes(z, turns, g[8], g[9], g[10]);
    return [
      ...taperRadius(z, g[4], r, length),
      ...powerTaper(z, r, g[11]),
      ...flare(z, g[5]),
      ...clampedFlare(z, g[5]),
      ...bulges(z, g[6], g[7]),
      value,
      byZ,
      byAngle,
      ...stemRadius(shapeOf(g), r, length, z, turns),
    ];
  },
  size: (given) => given[3],
  lines: [
    { name: 'taperRadius', parts: [0], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'taperRadius, slope', parts: [1], slope: true, tolerance: 1e-4, note: ANGLE },
    { name: 'powerTaper', parts: [2], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'powerTaper, slope', parts: [3], slope: true, tolerance: 1e-4, note: ANGLE },
    { name: 'flare', parts: [4], tolerance: 2e-5, note: 'of 1; exp2 is the GPU’s own' },
    { name: 'flare, slope', parts: [5], tolerance: 1e-3, note: 'of slopes up to 55; exp2 is the GPU’s own' },
    { name: 'clampedFlare', parts: [6], tolerance: 2e-5, note: 'of 1; exp2 is the GPU’s own' },
    { name: 'clampedFlare, slope', parts: [7], tolerance: 1e-3, note: 'of slopes up to 55; exp2 is the GPU’s own' },
    { name: 'bulges', parts: [8], tolerance: 2e-6, note: 'of 1' },
    { name: 'bulges, slope', parts: [9], tolerance: 2e-5, note: 'of slopes up to 13' },
    { name: 'lobes', parts: [10], tolerance: 2e-6, note: 'of 1' },
    { name: 'lobes, slopes', parts: [11, 12], tolerance: 2e-5, note: 'of slopes up to 3' },
    { name: 'stemRadius', parts: [13], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'stemRadius, slope', parts: [14], slope: true, tolerance: 1e-4, note: ANGLE },
    { name: 'stemRadius, q', parts: [15], tolerance: 2e-5, note: 'of slopes up to 3' },
  ],
};

/** Stems that are chains of spheres, off the necks between them: there the radius is the root of a difference that float32 has lost. */
const spheres: CheckProgram = {
  ...radius,
  name: 'chain of spheres',
  edges: [],
  inputs: (random) => {
    const [, turns, , length, , ...rest] = radius.inputs(random);
    const taper = between(random, 2.001, 3);
    const cone = length * magnitude(random, 1 / 100, 1 / 10);
    const sphere = Math.floor((random() * length) / (2 * cone));
    const left = 2 * cone * (sphere + between(random, 0.02, 0.98));
    return [Math.max(0, 1 - left / length), turns, cone, length, taper, ...rest];
  },
  lines: [
    { name: 'taperRadius, spheres', parts: [0], bySize: true, tolerance: 2e-5, note: METRES },
    { name: 'taperRadius, spheres, slope', parts: [1], slope: true, tolerance: 1e-4, note: ANGLE },
  ],
};

/** Radius, slope and q of a branch's kind; a radius below the curve's own, so that the surface does not fold over. */
const section = (random: Random, size: number): number[] => {
  const rho = random() < 0.1 ? 0 : size * magnitude(random, 1 / 500, 1 / 25);
  return [random(), rho, between(random, -3, 0.5) * rho, random() < 0.5 ? 0 : between(random, -1, 1)];
};

const surfaceResults = ({ position, normal, around, along }: SurfacePoint): number[] =>
  [position, normal, around, along].flatMap((vector) => [...vector, 0]);

const surfaceLines = (name: string): Line[] => [
  { name: `${name}, position`, parts: [0, 1, 2], error: 'vector', bySize: true, tolerance: 2e-5, note: METRES },
  { name: `${name}, normal`, parts: [4, 5, 6], error: 'vector', tolerance: 1e-4, note: ANGLE },
  { name: `${name}, tangents`, parts: [8, 9, 10, 12, 13, 14], tolerance: 1e-4, note: ANGLE },
];

const surface = (name: string, paper: boolean): CheckProgram => ({
  name,
  fragment: surfaceFragment,
  defines: paper ? { PAPER: 1 } : {},
  layers: 5,
  edges: degenerateCurves.flatMap((curve) =>
    [0, 0.5, 1].flatMap((u) => [
      [...curveInput(curve, [u, 1, 0.2, 0.1]), 0.1, 0, 0, 0], // the tip
      [...curveInput(curve, [u, 1, 0.2, 0.1]), 0.4, 0.02, -0.02, 0.3],
    ]),
  ),
  inputs: (random) => {
    const curve = framedCurve(random, 1.2);
    return [...curve, ...section(random, curveSize(curveOf(curve)))];
  },
  twin: (g) => {
    const curve = curveOf(g);
    const handles = handlesOf(curve, orientationOf(g));
    const [turns, rho, rhoU, q] = g.slice(16);
    const point = paper ? paperSurfacePoint : surfacePoint;
    return surfaceResults(point(curve, handles, g[3], cosTurns(turns), sinTurns(turns), rho, rhoU, q));
  },
  size: (given) => curveSize(curveOf(given)),
  lines: surfaceLines(name),
});

/** The functions on a stem's radius and the surface of a branch. */
export const surfacePrograms: readonly CheckProgram[] = [
  radius,
  spheres,
  surface('surfacePoint', false),
  surface('paperSurfacePoint', true),
];
