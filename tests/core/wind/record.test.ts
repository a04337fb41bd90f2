import { describe, expect, test } from 'vitest';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { windForce } from '../../../src/core/wind/force.ts';
import { playedRecord, RECORD_WIDTH, recordSeconds } from '../../../src/core/wind/record-state.ts';
import { forceOfSpeed } from '../../../src/core/wind/speed.ts';
import { STILL, type WindRecord } from '../../../src/core/wind/wind.ts';

/** A minute of a wind towards about 0.4 rad, sampled at 10 Hz, that begins at 6 m/s and ends at 12. */
const record: WindRecord = {
  name: 'minute',
  step: 0.1,
  speed: Array.from({ length: 600 }, (_, i) => 6 + 2 * Math.sin(i * 0.31) + i * 0.01),
  direction: Array.from({ length: 600 }, (_, i) => 0.4 + 0.3 * Math.sin(i * 0.11)),
};
const forceAt = (of: WindRecord, time: number, x = 0, y = 0, place = { x: 0, y: 0, yaw: 0 }): [number, number] =>
  windForce(windStateAt({ ...STILL, record: of }, time, place), x, y, 0);
const sample = ({ speed, direction }: WindRecord, i: number): [number, number] => [
  forceOfSpeed(speed[i] as number) * Math.cos(direction[i] as number),
  forceOfSpeed(speed[i] as number) * Math.sin(direction[i] as number),
];
const near = (a: [number, number], b: [number, number], digits = 6) => {
  expect(a[0]).toBeCloseTo(b[0], digits);
  expect(a[1]).toBeCloseTo(b[1], digits);
};

describe('record', () => {
  test('plays the samples as they are, and lines between them', () => {
    for (const i of [0, 1, 17, 300, 558]) near(forceAt(record, i * 0.1), sample(record, i));
    const [a, b] = [sample(record, 41), sample(record, 42)];
    near(forceAt(record, 4.125), [0.75 * a[0] + 0.25 * b[0], 0.75 * a[1] + 0.25 * b[1]]);
  });

  test('plays around and around, also backwards and after a month', () => {
    expect(recordSeconds(record)).toBeCloseTo(60, 12);
    near(forceAt(record, 63.2), forceAt(record, 3.2));
    near(forceAt(record, -5), forceAt(record, 55));
    near(forceAt(record, 60 * 43_200 + 3.2), forceAt(record, 3.2));
  });

  test('its end blends into its beginning: the seam is no steeper than the rest', () => {
    const steps = Array.from({ length: 6000 }, (_, i) => {
      const [a, b] = [forceAt(record, i / 100), forceAt(record, (i + 1) / 100)];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    });
    const body = Math.max(...steps.slice(0, 5500));
    expect(Math.max(...steps)).toBeLessThan(1.3 * body);
  });

  test('a point downwind hears what was heard upwind', () => {
    const { mean } = playedRecord(record);
    const speed = Math.hypot(...mean);
    const [dx, dy] = [mean[0] / speed, mean[1] / speed];
    near(forceAt(record, 20, 9 * dx, 9 * dy), forceAt(record, 20 - 9 / speed));
    near(forceAt(record, 20, 9 * dx - 5 * dy, 9 * dy + 5 * dx), forceAt(record, 20 - 9 / speed));
    near(forceAt(record, 20, -900 * dx, -900 * dy), forceAt(record, 20 + 900 / speed), 4);
  });

  test('a tree that stands elsewhere and is turned feels the same there', () => {
    const place = { x: 40, y: -17, yaw: 0.8 };
    const [cos, sin] = [Math.cos(0.8), Math.sin(0.8)];
    const [x, y] = forceAt(record, 12.3, 1, 3, place);
    near([x * cos - y * sin, x * sin + y * cos], forceAt(record, 12.3, 40 + cos - 3 * sin, -17 + sin + 3 * cos), 5);
  });

  test('two samples are enough; a calm and a wind from everywhere are no trouble', () => {
    const two: WindRecord = { name: 'two', step: 2, speed: [1, 3], direction: [0, 0] };
    expect(forceAt(two, 3)[0]).toBeCloseTo((forceOfSpeed(1) + forceOfSpeed(3)) / 2, 6);
    for (const odd of [
      { ...two, speed: [0, 0] },
      { ...two, speed: [2, 2], direction: [0, Math.PI] },
    ]) {
      expect(forceAt(odd, 1.3, 50, 20).every(Number.isFinite)).toBe(true);
    }
  });

  test('strength is a factor on it; without strength none is there', () => {
    const wind = { ...STILL, record, strength: 0.5 };
    near(windForce(windStateAt(wind, 2), 0, 0, 0), sample(record, 20).map((n) => n / 2) as [number, number]);
    expect(windStateAt({ ...wind, strength: 0 }, 2).record).toBeNull();
  });

  test('its texels are whole rows, the same array each time, each with the next sample beside it', () => {
    const { texels, count } = playedRecord(record);
    expect(texels.length).toBe(4 * RECORD_WIDTH);
    expect(count).toBe(600);
    expect(windStateAt({ ...STILL, record }, 5).record).toBe(texels);
    expect([...texels.subarray(4 * 599 + 2, 4 * 600)]).toEqual([...texels.subarray(0, 2)]);
  });
});
