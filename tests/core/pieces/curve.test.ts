import { describe, expect, it } from 'vitest';
import { arcLength, bezierArcLength, bezierPoint, type Cubic } from '../../../src/core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../../src/core/math/frames.ts';
import { combine, hashUnit } from '../../../src/core/math/hash.ts';
import { matrixFromQuaternion, type Quaternion, writeQuaternion } from '../../../src/core/math/quaternion.ts';
import { add, cross, dot, scale, subtract, unit, type Vec3 } from '../../../src/core/math/vec3.ts';
import {
  RECORD,
  recordArc,
  recordFrame,
  recordLength,
  recordParameter,
  recordPoint,
  transportRecord,
} from '../../../src/core/pieces/curve.ts';

let draws = 0;
const random = (): number => hashUnit(combine(3, draws++));
const anyVector = (): Vec3 => [random() - 0.5, random() - 0.5, random() - 0.5];

/** A random record with room before and after it, the same curve for the twins, and its orientation vector. */
function sample(): { record: Float64Array; at: number; curve: Cubic; o: Vec3 } {
  const p0 = anyVector();
  const p1 = add(p0, anyVector());
  const p2 = add(p1, anyVector());
  const p3 = add(p2, anyVector());
  const l = unit(subtract(p1, p0));
  const o = unit(cross(l, anyVector()));
  const record = new Float64Array(3 * RECORD);
  record.set([...p0, ...p1, ...p2, ...p3, ...o], RECORD);
  transportRecord(record, RECORD);
  return { record, at: RECORD, curve: { p0, p1, p2, p3 }, o };
}

/** The numbers of `out` from `at` on are those expected. */
function expectClose(out: Float64Array, at: number, expected: readonly number[]): void {
  for (const [k, x] of expected.entries()) expect(out[at + k]).toBeCloseTo(x, 9);
}

describe('records against the reference of core/math', () => {
  it('give the same points, lengths, handles and section frames', () => {
    const out = new Float64Array(9);
    for (let i = 0; i < 500; i++) {
      const { record, at, curve, o } = sample();
      const handles = handlesOf(curve, o);
      const u = random();
      recordPoint(record, at, u, out);
      expectClose(out, 0, bezierPoint(curve, u));
      expect(recordArc(record, at, 1)).toBeCloseTo(bezierArcLength(curve), 12);
      expect(recordLength(record, at)).toBeCloseTo(arcLength(curve), 12);
      expectClose(record, at + 12, [handles.t0, handles.t1, handles.t2].flat());
      recordFrame(record, at, u, out);
      expectClose(out, 0, sectionFrame(curve, handles, u).flat());
    }
  });

  it('find the parameter of an arc fraction', () => {
    for (let i = 0; i < 200; i++) {
      const { record, at } = sample();
      const arc = recordArc(record, at, 1);
      const fraction = random();
      const v = recordParameter(record, at, fraction, arc);
      // Random curves have cusps, where five points of Gauss-Legendre are coarse: the parameter must answer the same rule.
      expect(Math.abs(recordArc(record, at, v) - fraction * arc)).toBeLessThan(2e-3 * arc);
    }
    const { record, at } = sample();
    expect(recordParameter(record, at, -0.1, 1)).toBe(0);
    expect(recordParameter(record, at, 1.1, 1)).toBe(1);
  });

  it('turn columns into the quaternion with w >= 0, at half turns too', () => {
    const out = new Float64Array(8);
    for (let i = 0; i < 400; i++) {
      const axis = unit(anyVector());
      const half = i < 100 ? Math.PI / 2 - 1e-4 * random() : Math.PI * random();
      const q: Quaternion = [...scale(axis, Math.sin(half)), Math.cos(half)];
      writeQuaternion(Float64Array.from(matrixFromQuaternion(q).flat()), out, 4);
      const sign = q[3] < 0 ? -1 : 1;
      expect(out[7]).toBeGreaterThanOrEqual(0);
      for (let k = 0; k < 4; k++) expect(out[4 + k] * Math.sign(dot4(out, q) * sign)).toBeCloseTo(q[k] * sign, 9);
    }
  });
});

const dot4 = (a: Float64Array, q: Quaternion): number => dot([a[4], a[5], a[6]], [q[0], q[1], q[2]]) + a[7] * q[3];
