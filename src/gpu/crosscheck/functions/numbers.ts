import hashFragment from '../../../../shaders/debug/check-hash.frag';
import quaternionFragment from '../../../../shaders/debug/check-quaternion.frag';
import trigFragment from '../../../../shaders/debug/check-trig.frag';
import { hashPcg, hashUnit } from '../../../core/math/hash.ts';
import { matrixFromQuaternion, type Quaternion, rotateByQuaternion } from '../../../core/math/quaternion.ts';
import { texelOf } from '../../../core/math/texel.ts';
import { angleOfChord, cosTurns, power, sinTurns } from '../../../core/math/trig.ts';
import type { Vec3 } from '../../../core/math/vec3.ts';
import type { CheckProgram } from '../program.ts';
import { between, magnitude, rotation } from '../random.ts';

const trig: CheckProgram = {
  name: 'trig',
  fragment: trigFragment,
  layers: 1,
  edges: [
    [0, 0, 1, 0],
    [0.25, 1, 2.5, 2],
    [0.5, 1e-6, 1, 1e-4],
    [-0.5, 0, 8, 1],
    [-0.25, 1, 0.1, 0.5],
    [1, 0.5, 1, 0],
    [-7.75, 1e-3, 0.3, 0],
  ],
  inputs: (random) => [
    between(random, -1, 1) * magnitude(random, 0.1, 16),
    random(),
    magnitude(random, 0.2, 16),
    2 * random(),
  ],
  twin: ([turns, base, exponent, chord]) => [
    sinTurns(turns),
    cosTurns(turns),
    power(base, exponent),
    angleOfChord(chord),
  ],
  lines: [
    { name: 'sinTurns', parts: [0], tolerance: 2e-6, note: 'of 1; a polynomial, the same in both languages' },
    { name: 'cosTurns', parts: [1], tolerance: 2e-6, note: 'of 1; a polynomial, the same in both languages' },
    {
      name: 'power',
      parts: [2],
      tolerance: 1e-5,
      note: 'of 1; exp2 and log2 are the GPU’s own: GLSL ES asks 3 ulp of log2, times the exponent',
    },
    { name: 'angleOfChord', parts: [3], tolerance: 2e-6, note: 'radians' },
  ],
};

const hash: CheckProgram = {
  name: 'hash',
  fragment: hashFragment,
  layers: 1,
  edges: [
    [0, 0, 0, 0],
    [65535, 65535, 262143, 9],
    [32768, 0, 1023, 5],
    [0, 1, 1024, 5],
  ],
  inputs: (random) => {
    const log2Width = Math.floor(random() * 12);
    return [
      Math.floor(random() * 65536),
      Math.floor(random() * 65536),
      Math.floor(random() * Math.min(2 ** 24, 4 ** log2Width * 4)),
      log2Width,
    ];
  },
  twin: ([high, low, index, log2Width]) => {
    const value = hashPcg(((high << 16) | low) >>> 0);
    return [value >>> 16, value & 65535, hashUnit(value), 0, ...texelOf(index, log2Width)];
  },
  lines: [
    { name: 'hashPcg', parts: [0, 1], tolerance: 0, note: 'integers: exact' },
    { name: 'hashUnit', parts: [2], tolerance: 0, note: '24 bits: exact' },
    { name: 'texelOf', parts: [4, 5], tolerance: 0, note: 'integers: exact' },
  ],
};

const quaternion: CheckProgram = {
  name: 'quaternion',
  fragment: quaternionFragment,
  layers: 2,
  edges: [
    [0, 0, 0, 1, 1, 2, 3, 0],
    [1, 0, 0, 0, 1, 2, 3, 0],
    [0, 0, -1, 0, 0, 0, 0, 0],
  ],
  inputs: (random) => [...rotation(random), between(random, -1, 1), between(random, -1, 1), between(random, -1, 1), 0],
  twin: (given) => {
    const q = given.slice(0, 4) as Quaternion;
    const v = given.slice(4, 7) as Vec3;
    const [x, y, z] = matrixFromQuaternion(q);
    return [...rotateByQuaternion(q, v), 0, ...x, 0, ...y, 0, ...z, 0];
  },
  lines: [
    { name: 'rotateByQuaternion', parts: [0, 1, 2], error: 'vector', tolerance: 2e-6, note: 'of vectors up to 1.7' },
    { name: 'matrixFromQuaternion', parts: [4, 5, 6, 8, 9, 10, 12, 13, 14], tolerance: 2e-6, note: 'of 1' },
  ],
};

/** The functions on plain numbers. */
export const numberPrograms: readonly CheckProgram[] = [trig, hash, quaternion];
