import { describe, expect, test } from 'vitest';
import { ProbeHistory } from '../../../src/core/wind/probe-history.ts';
import { forceOfSpeed } from '../../../src/core/wind/speed.ts';
import { compare, comparedTable, differenceOf } from '../../../src/editor/studio/compare-data.ts';
import { csvOf } from '../../../src/editor/studio/csv.ts';
import { decibels, nearest, spectrumData, timeData, windowOf } from '../../../src/editor/studio/plot-data.ts';
import { spectrumTable, thinned, timeTable } from '../../../src/editor/studio/plot-tables.ts';

/** Of 1 m/s along each axis. */
const FORCE = forceOfSpeed(Math.SQRT2) / Math.SQRT2;

/** A swing along x of `size` metres at 1 Hz, from step `from` on. */
function history(from: number, count: number, size = 0.1): ProbeHistory {
  const made = new ProbeHistory();
  for (let n = from; n < from + count; n++) {
    made.push(n, { fx: FORCE, fy: FORCE, x: size * Math.sin((2 * Math.PI * n) / 60), y: 0, z: 0 });
  }
  return made;
}

/** Rows of a CSV file as a stranger reads them. */
const rowsOf = (csv: string): string[][] =>
  csv
    .trimEnd()
    .split('\r\n')
    .map((line) => line.split(','));

describe('what is plotted', () => {
  test('is the last seconds, the force as a speed', () => {
    const data = timeData(history(100, 3000), 0, 10);
    expect(data.time).toHaveLength(601);
    expect(data.time[600]).toBeCloseTo(3099 / 60, 9);
    expect(data.force[0]).toBeCloseTo(Math.SQRT2, 9);
    expect(data.forceAcross[0]).toBeCloseTo(1, 9);
    expect(Math.max(...data.along)).toBeCloseTo(0.1, 9);
  });

  test('is what the file holds, row by row', () => {
    const data = timeData(history(0, 120), 0, 10);
    const [header, ...rows] = rowsOf(csvOf(timeTable(data)));
    expect(header).toHaveLength(8);
    expect(header![0]).toBe('time (s)');
    expect(rows).toHaveLength(120);
    expect(Number(rows[30]![3])).toBeCloseTo(data.along[30]!, 6);
    expect(Number(rows[119]![0])).toBeCloseTo(data.time[119]!, 6);
  });

  test('is the spectrum too, with densities and what is drawn of them', () => {
    const spectra = spectrumData(history(0, 3600), 0);
    const [header, ...rows] = rowsOf(csvOf(spectrumTable(spectra)));
    expect(header![2]).toBe('displacement (dB below its peak)');
    const peak = rows.reduce((best, row) => (Number(row[2]) > Number(best[2]) ? row : best));
    expect(Number(peak[0])).toBeCloseTo(1, 1);
    expect(Number(peak[2])).toBe(0);
  });

  test('as a table ends with the newest row', () => {
    const thin = thinned(timeTable(timeData(history(0, 130), 0, 10)), 60);
    expect([...thin.columns[0]!.values].map((t) => Math.round(60 * t))).toEqual([9, 69, 129]);
  });
});

test('decibels are below the peak, not counting the mean', () => {
  expect([...decibels(new Float64Array([100, 1, 0.1, 0]), -60)]).toEqual([20, 0, -10, -60]);
  expect([...decibels(new Float64Array(3), -60)]).toEqual([-60, -60, -60]);
});

test('the nearest reading of a time, where there is one', () => {
  const { time } = timeData(history(60, 61), 0, 10);
  expect([nearest(time, 1), nearest(time, 1.51), nearest(time, 2)]).toEqual([0, 31, 60]);
  expect([nearest(time, 0.9), nearest(time, 2.1), nearest(new Float64Array(0), 1)]).toEqual([-1, -1, -1]);
});

test('the window is full from its beginning on and moves when time has filled it', () => {
  expect(windowOf(4, 10)).toEqual([0, 10]);
  expect(windowOf(14, 10)).toEqual([4, 14]);
});

describe('two winds', () => {
  test('are compared at the times that both have', () => {
    const data = compare(history(0, 300, 0.1), history(100, 250, 0.3), 0, 60);
    expect([data.time[0], data.time.length]).toEqual([100 / 60, 200]);
    expect(data.difference[15]).toBeCloseTo(data.b[15]! - data.a[15]!, 12);
    const found = differenceOf(data)!;
    expect(found.greatest).toBeCloseTo(0.2, 3);
    expect(found.rms).toBeGreaterThan(0.1);
    expect(comparedTable(data).columns.map((c) => c.values.length)).toEqual([200, 200, 200, 200]);
  });

  test('with nothing in common say nothing', () => {
    const data = compare(history(0, 10), history(100, 10), 0, 60);
    expect(data.time).toHaveLength(0);
    expect(differenceOf(data)).toBeNull();
    expect(differenceOf(compare(new ProbeHistory(), history(0, 10), 0, 60))).toBeNull();
  });
});

test('a file quotes names with commas, and leaves out what is no number', () => {
  const csv = csvOf({ name: 't', columns: [{ name: 'a, "b"', values: new Float64Array([1 / 3, Number.NaN]) }] });
  expect(csv).toBe('"a, ""b"""\r\n0.3333333\r\n\r\n');
});
