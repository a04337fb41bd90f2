import bendFragment from '../../../../shaders/debug/check-bend.frag';
import poseFragment from '../../../../shaders/debug/check-pose.frag';
import springFragment from '../../../../shaders/debug/check-spring.frag';
import swayFragment from '../../../../shaders/debug/check-sway.frag';
import type { Cubic } from '../../../core/math/bezier.ts';
import { matrixFromQuaternion, type Quaternion } from '../../../core/math/quaternion.ts';
import { addScaled, type Vec3 } from '../../../core/math/vec3.ts';
import {
  type BendModel,
  bendPiece,
  bendVector,
  directPush,
  framePush,
  mixPush,
  type Push,
} from '../../../core/wind/bend.ts';
import { attachRoot, bendPose, type Pose, poseFromParent, type RestPiece } from '../../../core/wind/pose.ts';
import {
  mixSpring,
  type Spring,
  springBend,
  springStart,
  springStep,
  springStir,
  springTarget,
  springTransition,
} from '../../../core/wind/spring.ts';
import { swayClock, swayPhase, swayStir, swaySwing } from '../../../core/wind/sway.ts';
import type { CheckProgram } from '../program.ts';
import { between, direction, magnitude, near, type Random, rotation } from '../random.ts';
import { curveInput, curveOf, curveSize, degenerateCurves, framedCurve, randomCurve } from './curve-inputs.ts';

const METRES = 'of the branch’s size';
const ANGLE = 'radians';

/** The exponents and forms of the bend: the default, the literal paper's, and its printed step. */
const MODELS: Readonly<Record<string, BendModel>> = {
  default: { forceExponent: 1, lengthExponent: 1, softness: 0.8, paper: false },
  'p 1.8, m 2': { forceExponent: 1.8, lengthExponent: 2, softness: 1, paper: false },
  paper: { forceExponent: 1.8, lengthExponent: 2, softness: 1, paper: true },
};

const bendUniforms = (model: BendModel) => ({
  windExponents: { value: [model.forceExponent, model.lengthExponent] },
  windSoftness: { value: model.softness },
});

const bendDefines = (model: BendModel): Record<string, number> => (model.paper ? { WIND_PAPER: 1 } : {});

/** A force that bends a stem of this size by up to a right angle; where `storm` is 1 sometimes one that would break it. */
const forceFor = (random: Random, size: number, storm = 0): [number, number] => {
  const most = (size / 3) * 1.5 * (random() < 0.1 * storm ? 100 : 1);
  return [most * between(random, -1, 1), most * between(random, -1, 1)];
};

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
    const values = [...forceFor(random, size, model.paper ? 0 : 1), size / 3, size * between(random, 0.8, 1.2)];
    const p = random() < 0.5 ? 1 : between(random, 1, 2);
    return [...curveInput(curve, values), 0.14 * random(), random(), p, Math.floor(3 * random())];
  },
  twin: (g) => {
    const push = directPush([g[3], g[7]], g[11], [g[16], g[17]], model);
    const { p1, p2, p3 } = bendPiece(curveOf(g), push, g[15], model.paper);
    return [...p1, 0, ...p2, 0, ...p3, 0, ...bendVector(g[3], g[7], g[11], g[18], g[19]), 0];
  },
  size: (g) => Math.max(curveSize(curveOf(g)), g[15]) * (model.paper ? reach(g, model) : 1),
  lines: [
    { name: `bendPiece (${name})`, parts: [0, 1, 2, 4, 5, 6, 8, 9, 10], bySize: true, tolerance: 2e-5, note: METRES },
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
  const push = (most: number): number[] => [1, 2, 3].map(() => most * between(random, -1.5, 1.5));
  return [...curve, ...turn, ...p2, edge, ...p3, size, ...push(0.3), root, ...push(1), random()];
}

const restOf = (g: readonly number[]): RestPiece => ({
  v: g[15],
  orientation: g.slice(16, 20) as Quaternion,
  p2: g.slice(20, 23) as Vec3,
  p1x: g[23],
  p3: g.slice(24, 27) as Vec3,
  arc: g[27],
  // The pose asks for a push, which holds them already.
  weights: [1, 1],
  third: 1,
});

const pushOf = (g: readonly number[]): Push => ({ second: g.slice(28, 31) as Vec3, third: g.slice(32, 35) as Vec3 });

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
      ...[0.5, 0.5, 0.5, 0.5],
      ...[0.6, 0.1, 0, 0.3],
      ...[0.8, 0.3, 0, 1],
      ...[0.03, 0.014, 0, 0],
      ...[0.2, 0.1, 0, 0.4],
    ]),
  ),
  inputs: poseInputs,
  twin: (g) => {
    const rest = restOf(g);
    const push = pushOf(g);
    let posed: Pose;
    if (g[31] > 0.5) posed = bendPose(attachRoot([g[0], g[1], g[2]], rest), rest, push, g[35], model.paper);
    else posed = poseFromParent(curveOf(g), [g[3], g[7], g[11]], rest, push, g[35], model.paper);
    const { curve, o, stir } = posed;
    return [...curve.p0, o[0], ...curve.p1, o[1], ...curve.p2, o[2], ...curve.p3, stir];
  },
  size: (g) => Math.max(curveSize(curveOf(g)), g[27]) * (model.paper ? 3 : 1),
  lines: [
    {
      name: `poseFromParent (${name})`,
      parts: [0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14],
      bySize: true,
      tolerance: 2e-5,
      note: METRES,
    },
    { name: `poseFromParent (${name}), O`, parts: [3, 7, 11], error: 'vector', tolerance: 1e-4, note: ANGLE },
    { name: `poseFromParent (${name}), stir`, parts: [15], tolerance: 0, note: 'handed through' },
  ],
});

const stateOf = (g: readonly number[], at: number): Spring => ({
  q: [g[at], g[at + 1]],
  velocity: [g[at + 2], g[at + 3]],
  base: g.slice(at + 4, at + 7) as Vec3,
  force: g[at + 7],
  end: g.slice(at + 8, at + 11) as Vec3,
  along: g[at + 11],
});

/** Two states of three layers, a frame, and what a step takes: beta, lever | acceleration, reach | transition. */
const spring: CheckProgram = {
  name: 'spring',
  fragment: springFragment,
  uniforms: bendUniforms(MODELS.default),
  layers: 10,
  edges: [
    // Slowest and fastest, hardly damped and far beyond the critical damping.
    ...[0.5, 12, 600].flatMap((omega) =>
      [0.01, 1, 30].map((damping) => [
        ...[1, 0.5, 3, -2, 0, 0, 0, 0.1, 0, 0, 0, 0.2],
        ...[0.2, 0, 1, 0, 1, 2, 3, 0.2, 1, 1, 1, 0],
        ...[0.5, 0.5, 0.5, 0.5],
        ...[0.3, -0.4, 0, 5, 3, -2, 1, 0.8],
        ...springTransition(omega, damping, 1 / 60),
      ]),
    ),
  ],
  inputs: (random) => {
    const some = (n: number, most: number): number[] => Array.from({ length: n }, () => most * between(random, -1, 1));
    const state = (): number[] => [
      ...some(2, 2),
      ...some(2, 10),
      ...some(3, 30),
      random(),
      ...some(3, 30),
      between(random, -1, 1),
    ];
    return [
      ...state(),
      ...state(),
      ...rotation(random),
      ...[...some(2, 2), 0, magnitude(random, 1e-4, 3)],
      ...[...direction(random).map((x) => 30 * x * random()), random()],
      ...springTransition(magnitude(random, 0.5, 12), magnitude(random, 0.02, 3), 1 / 60),
    ];
  },
  twin: (g) => {
    const frame = matrixFromQuaternion(g.slice(24, 28) as Quaternion);
    const base = g.slice(32, 35) as Vec3;
    const beta: Vec3 = [g[28], g[29], 0];
    const target = springTarget(frame, beta, base, g[31]);
    const first = stateOf(g, 0);
    const [b11, b12, b21, b22] = g.slice(36, 40);
    const next = springStep(first, target, [b11, b12, b21, b22], frame, base, g[35], g[7]);
    const mixed = mixSpring(first, stateOf(g, 12), g[35]);
    const begun = springStart(target, g[7]);
    const { third } = framePush(frame, springBend(mixed), [0.14, 0.6], 0.8);
    return [
      ...next.q,
      ...next.velocity,
      ...next.end,
      next.along,
      ...begun.q,
      begun.force,
      begun.along,
      ...third,
      springStir(mixed, 0.3),
    ];
  },
  lines: [
    { name: 'springStep, bend', parts: [0, 1], tolerance: 2e-5, note: 'bends of up to 3' },
    { name: 'springStep, velocity', parts: [2, 3], tolerance: 2e-4, note: '1/s, of up to 30' },
    {
      name: 'springStep, acceleration',
      parts: [4, 5, 6],
      tolerance: 2e-2,
      note: 'm/s², of up to 2000; differences of steps of 1/60 s',
    },
    { name: 'springTarget', parts: [7, 8, 9, 11], tolerance: 2e-5, note: 'bends of up to 3' },
    { name: 'mixSpring, springBend, framePush', parts: [12, 13, 14], tolerance: 2e-5, note: 'bends of up to 3' },
    { name: 'springStir', parts: [15], tolerance: 2e-5, note: 'metres of force' },
  ],
};

/** Gain, offset and time, then the amplitudes. */
const sway: CheckProgram = {
  name: 'sway',
  fragment: swayFragment,
  layers: 4,
  edges: [0, 4095.999, 4096, 1e7].map((time) => [
    0.1,
    0.3,
    16384,
    11469,
    0.2,
    0.9,
    0,
    0,
    ...swayClock(time),
    0,
    0,
    0.1,
    0.2,
    0.3,
  ]),
  inputs: (random) => {
    const k = Math.floor(magnitude(random, 1, 16384));
    const clock = swayClock(magnitude(random, 0.1, 1e8));
    return [
      random(),
      random(),
      k,
      Math.round(0.7 * k),
      random(),
      random(),
      0,
      0,
      ...clock,
      0,
      0,
      random(),
      random(),
      random(),
      0,
    ];
  },
  twin: (g) => {
    const parts = g.slice(12, 16);
    const clock = g.slice(8, 10);
    const swing = swaySwing(g.slice(0, 4), g.slice(4, 6), parts, clock);
    const phase = swayPhase(g[2], clock);
    const other = { second: [1, 2, 3] as Vec3, third: [3, 2, 1] as Vec3 };
    const mixed = mixPush({ second: [0, 0, 0], third: [...swing, 0] }, other, g[0]);
    return [...swing, swayStir(swing, parts), phase - Math.floor(phase), ...mixed.second, 0, ...mixed.third, 0];
  },
  lines: [
    { name: 'swaySwing', parts: [0, 1], tolerance: 2e-5, note: 'of up to 2' },
    { name: 'swayStir', parts: [2], tolerance: 2e-5, note: 'metres of force' },
    { name: 'mixPush', parts: [4, 5, 6, 8, 9, 10], tolerance: 2e-5, note: 'pushes of up to 3' },
  ],
};

/** What the bend models do, and the pose, function by function. */
export const bendPrograms: readonly CheckProgram[] = [
  ...Object.entries(MODELS).map(([name, model]) => bend(name, model)),
  spring,
  sway,
  ...Object.entries(MODELS).map(([name, model]) => pose(name, model)),
];
