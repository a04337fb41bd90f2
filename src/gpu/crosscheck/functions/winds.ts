import bendFragment from '../../../../shaders/debug/check-bend.frag';
import forceFragment from '../../../../shaders/debug/check-force.frag';
import poseFragment from '../../../../shaders/debug/check-pose.frag';
import type { Cubic } from '../../../core/math/bezier.ts';
import type { Quaternion } from '../../../core/math/quaternion.ts';
import { addScaled, type Vec3 } from '../../../core/math/vec3.ts';
import { type BendModel, bendPiece, bendVector } from '../../../core/wind/bend.ts';
import { createWaveUniforms, linearWindForce, type WaveUniforms, windForce } from '../../../core/wind/force.ts';
import { attachRoot, bendPose, type Pose, poseFromParent, type RestPiece } from '../../../core/wind/pose.ts';
import type { CheckProgram } from '../program.ts';
import { between, magnitude, near, type Random, randomStream, rotation } from '../random.ts';
import { curveInput, curveOf, curveSize, degenerateCurves, framedCurve, randomCurve } from './curve-inputs.ts';

const METRES = 'of the branch’s size';
const ANGLE = 'radians';

/** `count` waves of every kind. Peaks of up to a metre: the error in parts of a metre is that in parts of the force. */
function randomWaves(count: number, seed: number): WaveUniforms {
  const random = randomStream(seed);
  const waves = createWaveUniforms();
  waves.count = count;
  for (let i = 0; i < count; i++) {
    const angle = 2 * Math.PI * random();
    waves.waves.set([Math.cos(angle), Math.sin(angle), random() / count, between(random, 0.5, 8)], 4 * i);
    waves.phases.set([1 / magnitude(random, 2, 100), random()], 2 * i);
  }
  return waves;
}

const force = (count: number): CheckProgram => {
  const waves = randomWaves(count, 20 + count);
  return {
    name: `force of ${count}`,
    fragment: forceFragment,
    defines: { WIND_WAVES: count > 4 ? 8 : 4 },
    uniforms: {
      windWaves: { value: waves.waves },
      windPhases: { value: waves.phases },
    },
    layers: 1,
    edges: [[0, 0]],
    inputs: (random) => [between(random, -40, 40), between(random, -40, 40)],
    twin: ([x, y]) => [...windForce(waves, x, y), ...linearWindForce(waves, x, y)],
    lines: [
      {
        name: `windForce, ${count} waves`,
        parts: [0, 1],
        tolerance: 2e-5,
        note: 'of the peak; 40 m are up to 20 turns, of which float32 knows 1e-6',
      },
      { name: `linearWindForce, ${count} waves`, parts: [2, 3], tolerance: 2e-5, note: 'of the peak' },
    ],
  };
};

/** The exponents and forms of the bend: the default, the literal paper's, and its printed step. */
const MODELS: Readonly<Record<string, BendModel>> = {
  default: { forceExponent: 1, lengthExponent: 1, paper: false },
  'p 1.8, m 2': { forceExponent: 1.8, lengthExponent: 2, paper: false },
  paper: { forceExponent: 1.8, lengthExponent: 2, paper: true },
};

const bendUniforms = (model: BendModel) => ({
  windExponents: { value: [model.forceExponent, model.lengthExponent] },
});

const bendDefines = (model: BendModel): Record<string, number> => (model.paper ? { WIND_PAPER: 1 } : {});

/** A force that bends a stem of this size by up to a right angle. */
const forceFor = (random: Random, size: number): [number, number] => [
  (size / 3) * between(random, -1.5, 1.5),
  (size / 3) * between(random, -1.5, 1.5),
];

/** A curve of metres: in the paper's model, F^1.8 / l^2, the bend depends on the scale. */
const bendCurve = (random: Random): Cubic => randomCurve(random, 1.2);

const bend = (name: string, model: BendModel): CheckProgram => ({
  name: `bend ${name}`,
  fragment: bendFragment,
  uniforms: bendUniforms(model),
  defines: bendDefines(model),
  layers: 5,
  edges: degenerateCurves.map((curve) => [...curveInput(curve, [0.3, 0.1, 1, 3]), 0.138, 1, 1, 0]),
  inputs: (random) => {
    const curve = bendCurve(random);
    const size = curveSize(curve);
    const values = [...forceFor(random, size), size / 3, size * between(random, 0.8, 1.2)];
    const p = random() < 0.5 ? 1 : between(random, 1, 2);
    return [...curveInput(curve, values), 0.14 * random(), random(), p, Math.floor(3 * random())];
  },
  twin: (g) => {
    const bent = bendPiece(curveOf(g), [g[3], g[7]], g[11], [g[16], g[17]], g[15], model);
    const { p1, p2, p3 } = bent.curve;
    return [...p1, bent.angle, ...p2, 0, ...p3, 0, ...bendVector(g[3], g[7], g[11], g[18], g[19]), 0];
  },
  size: (g) => Math.max(curveSize(curveOf(g)), g[15]) * reach(g, model),
  lines: [
    { name: `bendPiece (${name})`, parts: [0, 1, 2, 4, 5, 6, 8, 9, 10], bySize: true, tolerance: 2e-5, note: METRES },
    { name: `bendPiece (${name}), angle`, parts: [3], tolerance: 1e-4, note: ANGLE },
    ...(name === 'default'
      ? [
          {
            name: 'bendVector',
            parts: [12, 13, 14],
            relative: true,
            tolerance: 2e-5,
            note: 'of the bend; exp2 and log2 are the GPU’s own',
          },
        ]
      : []),
  ],
});

/** How much longer the wind may make the branch: the paper's step keeps no length, and a bend vector may exceed 1. */
function reach(g: readonly number[], { forceExponent, lengthExponent }: BendModel): number {
  const vectors = [
    bendVector(g[3], g[7], g[11], g[18], g[19]),
    bendVector(g[3], g[7], g[11], forceExponent, lengthExponent),
  ];
  return Math.max(1, ...vectors.map((vector) => Math.hypot(...vector)));
}

/** A parent's frame and a piece on it, nine layers; `root`: it stands at the parent's P0 instead. */
function poseInputs(random: Random): number[] {
  const parent = framedCurve(random, 1.2);
  const o = [parent[7], parent[11], parent[15]];
  const v = random() < 0.25 ? 1 : random();
  const curve = curveInput(curveOf(parent), [...o, v]);
  const size = curveSize(curveOf(parent)) * between(random, 0.2, 1);
  const edge = size / 3;
  const d1 = near(random, [1, 0, 0], 1);
  const p2 = addScaled([edge, 0, 0], d1, edge);
  const p3 = addScaled(p2, near(random, d1, 1), edge);
  const turn = random() < 0.2 ? [0, 0, 0, 1] : rotation(random);
  const root = random() < 0.1 ? 1 : 0;
  return [...curve, ...turn, ...p2, edge, ...p3, size, ...forceFor(random, size), 0.14, random(), size / 3, root, 0, 0];
}

const restOf = (g: readonly number[]): RestPiece => ({
  v: g[15],
  orientation: g.slice(16, 20) as Quaternion,
  p2: g.slice(20, 23) as Vec3,
  p1x: g[23],
  p3: g.slice(24, 27) as Vec3,
  arc: g[27],
  weights: [g[30], g[31]],
  third: g[32],
});

const pose = (name: string, model: BendModel): CheckProgram => ({
  name: `pose ${name}`,
  fragment: poseFragment,
  uniforms: bendUniforms(model),
  defines: bendDefines(model),
  layers: 9,
  // On parents with coinciding control points, at both ends.
  edges: degenerateCurves.flatMap((curve) =>
    [0, 1].map((v) => [
      ...curveInput(curve, [1, 0.2, 0.1, v]),
      0.5,
      0.5,
      0.5,
      0.5,
      0.6,
      0.1,
      0,
      0.3,
      0.8,
      0.3,
      0,
      1,
      0.2,
      0.1,
      0.14,
      1,
      0.33,
      0,
    ]),
  ),
  inputs: poseInputs,
  twin: (g) => {
    const rest = restOf(g);
    const force: [number, number] = [g[28], g[29]];
    let posed: Pose;
    if (g[33] > 0.5) posed = bendPose(attachRoot([g[0], g[1], g[2]], rest), rest, force, model);
    else posed = poseFromParent(curveOf(g), [g[3], g[7], g[11]], rest, force, model);
    const { curve, o, angle } = posed;
    return [...curve.p0, o[0], ...curve.p1, o[1], ...curve.p2, o[2], ...curve.p3, angle];
  },
  size: (g) =>
    Math.max(curveSize(curveOf(g)), g[27]) *
    Math.max(1, Math.hypot(...bendVector(g[28], g[29], g[32], model.forceExponent, model.lengthExponent))),
  lines: [
    {
      name: `poseFromParent (${name})`,
      parts: [0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14],
      bySize: true,
      tolerance: 2e-5,
      note: METRES,
    },
    { name: `poseFromParent (${name}), O`, parts: [3, 7, 11], error: 'vector', tolerance: 1e-4, note: ANGLE },
    { name: `poseFromParent (${name}), angle`, parts: [15], tolerance: 1e-4, note: ANGLE },
  ],
});

/** The three stages of the wind pass, function by function. */
export const windPrograms: readonly CheckProgram[] = [
  force(2),
  force(4),
  force(8),
  ...Object.entries(MODELS).map(([name, model]) => bend(name, model)),
  ...Object.entries(MODELS).map(([name, model]) => pose(name, model)),
];
