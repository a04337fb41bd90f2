import { DataTexture, FloatType, type IUniform, NearestFilter, RGBAFormat } from 'three';
import forceFragment from '../../../../shaders/debug/check-force.frag';
import partsFragment from '../../../../shaders/debug/check-force-parts.frag';
import { createWindState, type WindState, windStateAt } from '../../../core/wind/fade.ts';
import { linearWindForce, wavePush, wavesForce, windForce } from '../../../core/wind/force.ts';
import { forceDefines, forceUniforms } from '../../../core/wind/force-variant.ts';
import { gustEnvelope, gustPush, gustsForce, gustWidth } from '../../../core/wind/gust.ts';
import { profileFactor } from '../../../core/wind/profile.ts';
import { RECORD_WIDTH, recordForce } from '../../../core/wind/record-state.ts';
import { type Gust, STILL, type Wave, type Wind, type WindRecord } from '../../../core/wind/wind.ts';
import type { CheckProgram } from '../program.ts';
import { between, magnitude, type Random, randomStream } from '../random.ts';

/** Waves of every kind. Peaks of up to a metre in all: the error in parts of a metre is that in parts of the force. */
const randomWave = (random: Random, count: number): Wave => ({
  on: true,
  solo: false,
  amplitude: between(random, 0.05, 1) / count,
  direction: 2 * Math.PI * random(),
  wavelength: magnitude(random, 2, 100),
  speed: between(random, 0, 12),
  sharpness: between(random, 0.5, 8),
  phase: random(),
});

/** Gusts that are about the tree at 20 s. */
const randomGust = (random: Random): Gust => ({
  start: between(random, 15, 20),
  x: between(random, -20, 20),
  y: between(random, -20, 20),
  direction: 2 * Math.PI * random(),
  speed: between(random, 4, 25),
  amplitude: between(random, 0.02, 0.12),
  rise: between(random, 0.5, 3),
  fall: between(random, 1, 6),
  width: random() < 0.3 ? 0 : between(random, 5, 60),
  repeat: random() < 0.5 ? 0 : between(random, 9, 14),
});

/** A record of two rows of its texture, around whose end the tree stands at 20 s. */
function randomRecord(random: Random): WindRecord {
  const count = RECORD_WIDTH + 176;
  const walk = (low: number, high: number) => Array.from({ length: count }, () => between(random, low, high));
  return { name: 'random', step: 20 / (count - 3), speed: walk(0, 12), direction: walk(-0.6, 2.4) };
}

/** A wind of every part. */
function randomWind(count: number, rest: Partial<Wind>): Wind {
  const random = randomStream(20 + count);
  return {
    ...STILL,
    waves: Array.from({ length: count }, () => randomWave(random, count)),
    gusts: Array.from({ length: 8 }, () => randomGust(random)),
    record: randomRecord(random),
    ...rest,
  };
}

const PLACE = { x: 3, y: -5, yaw: 0.7 };

function textureOf({ record }: WindState): IUniform {
  const texels = record as Float32Array<ArrayBuffer>;
  const texture = new DataTexture(texels, RECORD_WIDTH, texels.length / (4 * RECORD_WIDTH), RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return { value: texture };
}

function uniformsOf(state: WindState): Record<string, IUniform> {
  const values = Object.entries(forceUniforms(state)).map(([name, value]) => [name, { value }] as const);
  return { ...Object.fromEntries(values), ...(state.record ? { windRecord: textureOf(state) } : {}) };
}

const OF_PEAK = 'of the peak; 40 m are up to 20 turns, of which float32 knows 1e-6';

/** The waves alone, in the variant of as many slots. */
function waves(count: number, zeroMean: boolean): CheckProgram {
  const state = createWindState();
  windStateAt({ ...randomWind(Math.min(count, 8), { gusts: [], record: null, zeroMean }) }, 20, PLACE, state);
  // Sixteen blow only while one wind fades into another: the eight twice.
  for (let i = state.count; i < count; i++) {
    state.waves.set(state.waves.subarray(4 * (i - 8), 4 * (i - 7)), 4 * i);
    state.phases.set(state.phases.subarray(4 * (i - 8), 4 * (i - 7)), 4 * i);
    state.phases[4 * i + 1] += 0.1;
  }
  state.count = count;
  const name = `${count} waves${zeroMean ? ' without mean' : ''}`;
  return {
    name: `force of ${name}`,
    fragment: forceFragment,
    defines: forceDefines(state),
    uniforms: uniformsOf(state),
    layers: 1,
    edges: [[0, 0, 0]],
    inputs: (random) => [between(random, -40, 40), between(random, -40, 40), between(random, 0, 20)],
    twin: ([x, y, z]) => {
      const push = wavePush(state, 0, x, y);
      const first = [state.waves[0] * push, state.waves[1] * push];
      return [...windForce(state, x, y, z), ...linearWindForce(state, x, y), ...wavesForce(state, x, y), ...first];
    },
    lines: [
      { name: `windForce, ${name}`, parts: [0, 1], tolerance: 2e-5, note: OF_PEAK },
      { name: `linearWindForce, ${name}`, parts: [2, 3], tolerance: 2e-5, note: 'of the peak' },
      { name: `wavesForce, ${name}`, parts: [4, 5], tolerance: 2e-5, note: 'of the peak' },
      { name: `wavePush, ${name}`, parts: [6, 7], tolerance: 2e-5, note: 'of the peak' },
    ],
  };
}

const KINDS = {
  log: { kind: 'log', height: 10, roughness: 0.3, exponent: 0.2 },
  power: { kind: 'power', height: 10, roughness: 0.3, exponent: 0.22 },
} as const;

/** All of a wind at once, at every height. */
function whole(kind: keyof typeof KINDS): CheckProgram {
  const state = windStateAt(randomWind(4, { profile: KINDS[kind] }), 20, PLACE);
  return {
    name: `force of waves, gusts, record and profile ${kind}`,
    fragment: forceFragment,
    defines: forceDefines(state),
    uniforms: uniformsOf(state),
    layers: 1,
    edges: [
      [0, 0, 0],
      [0, 0, -1],
      [1, 2, 10],
    ],
    inputs: (random) => [between(random, -40, 40), between(random, -40, 40), between(random, -1, 30)],
    twin: ([x, y, z]) => [...windForce(state, x, y, z)],
    lines: [
      {
        name: `windForce, all of a wind (${kind})`,
        parts: [0, 1],
        tolerance: 1e-4,
        note: 'metres, of forces of up to one; the record is noise',
      },
    ],
  };
}

function parts(kind: keyof typeof KINDS): CheckProgram {
  const state = windStateAt(randomWind(1, { profile: KINDS[kind] }), 20, PLACE);
  return {
    name: `gusts, record and profile ${kind}`,
    fragment: partsFragment,
    defines: forceDefines(state),
    uniforms: uniformsOf(state),
    layers: 2,
    // At the front, at the peak, at the end; at and below the ground, and at the height of the profile.
    edges: [
      [0, 0, 0, 0, 1, 2, 0, 0],
      [0, 0, -1, 1, 1, 2, 0, 0.1],
      [0, 0, 10, 3, 1, 2, 5, 0.1],
      [0, 0, 0.3, -1, 1, 2, 1e4, 1],
    ],
    inputs: (random) => [
      between(random, -40, 40),
      between(random, -40, 40),
      random() < 0.3 ? between(random, -1, 1) : between(random, 0, 40),
      between(random, -1, 9),
      between(random, 0.2, 4),
      between(random, 0.2, 6),
      between(random, -50, 50),
      random() < 0.2 ? 0 : 1 / between(random, 5, 100),
    ],
    twin: ([x, y, z, s, rise, fall, d, perWidth]) => {
      const push = gustPush(state, 0, x, y);
      return [
        ...gustsForce(state, x, y),
        ...recordForce(state, x, y),
        profileFactor(state, z),
        gustEnvelope(s, rise, fall),
        gustWidth(d, perWidth),
        0,
        state.gusts[0] * push,
        state.gusts[1] * push,
        push,
      ];
    },
    lines: [
      {
        name: `profileFactor (${kind})`,
        parts: [4],
        relative: true,
        tolerance: 1e-5,
        note: 'exp2 and log2 are the GPU’s own',
      },
      ...(kind === 'log'
        ? [
            { name: 'gustsForce', parts: [0, 1], tolerance: 2e-5, note: 'metres, of peaks of up to 0.12' },
            {
              name: 'recordForce',
              parts: [2, 3],
              tolerance: 1e-4,
              note: 'metres, of noise of up to 0.26; 40 m are 400 samples, of which float32 knows 3e-5',
            },
            { name: 'gustEnvelope', parts: [5], tolerance: 1e-5, note: 'of the peak' },
            { name: 'gustWidth', parts: [6], tolerance: 1e-5, note: 'of the peak' },
            { name: 'gustForce', parts: [8, 9], tolerance: 1e-5, note: 'metres' },
            { name: 'gustPush', parts: [10], tolerance: 1e-5, note: 'metres' },
          ]
        : []),
    ],
  };
}

/** The force of the wind, function by function and whole. */
export const forcePrograms: readonly CheckProgram[] = [
  waves(2, false),
  waves(4, false),
  waves(8, false),
  waves(8, true),
  waves(16, false),
  parts('log'),
  parts('power'),
  whole('log'),
  whole('power'),
];
