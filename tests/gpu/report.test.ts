import { expect, test } from 'vitest';
import { compareLine, type Line, PARTS, type Results } from '../../src/gpu/crosscheck/compare.ts';
import { check, report } from '../../src/gpu/crosscheck/report.ts';

test('a check without samples, beyond its tolerance or not a number fails', () => {
  expect(check('a', 1, 0.1, 0.1, '').pass).toBe(true);
  expect(check('a', 0, 0, 0.1, '').pass).toBe(false);
  expect(check('a', 1, 0.2, 0.1, '').pass).toBe(false);
  expect(check('a', 1, Number.NaN, 0.1, '')).toMatchObject({ pass: false, maxError: -1 });
  expect(check('a', 1, Infinity, 0.1, '')).toMatchObject({ pass: false, maxError: -1 });
});

test('a report passes when there are checks and all pass', () => {
  const good = check('a', 1, 0, 0, '');
  const bad = check('b', 1, 1, 0, '');
  expect(report('gpu', [good], 1).pass).toBe(true);
  expect(report('gpu', [good, bad], 1).pass).toBe(false);
  expect(report('gpu', [], 1, 'no float targets')).toMatchObject({ pass: false, reason: 'no float targets' });
});

/** Two samples; part 0 and 1 of the second differ by 3 and 4. */
function results(change: (gpu: Float32Array, twin: Float64Array) => void = () => {}): Results {
  const gpu = new Float32Array(2 * PARTS);
  const twin = new Float64Array(2 * PARTS);
  gpu[PARTS] = 3;
  gpu[PARTS + 1] = 4;
  change(gpu, twin);
  return { samples: 2, gpu, twin, size: new Float64Array([1, 10]) };
}

const line = (more: Partial<Line>): Line => ({ name: 'x', parts: [0, 1], tolerance: 1, note: '', ...more });

test('errors are taken part by part, as a vector, by size, by the length of the vector, or as slopes', () => {
  expect(compareLine(line({}), results()).maxError).toBe(4);
  expect(compareLine(line({ error: 'vector' }), results()).maxError).toBe(5);
  expect(compareLine(line({ bySize: true }), results()).maxError).toBeCloseTo(0.4);
  const far = results((gpu, twin) => {
    twin[PARTS] = 100;
    gpu[PARTS] = 101;
    gpu[PARTS + 1] = 0;
  });
  expect(compareLine(line({ relative: true }), far).maxError).toBeCloseTo(0.01);
  const steep = results((gpu, twin) => {
    gpu[PARTS] = 1e6;
    twin[PARTS] = 2e6;
    gpu[PARTS + 1] = 0;
  });
  expect(compareLine(line({ slope: true }), steep).maxError).toBeLessThan(1e-5);
  expect(compareLine(line({ parts: [2] }), results()).maxError).toBe(0);
});

test('one number that is not a number fails the line, wherever it stands', () => {
  for (const at of [0, PARTS + 1]) {
    const broken = results((gpu) => {
      gpu[at] = Number.NaN;
    });
    expect(compareLine(line({}), broken)).toMatchObject({ pass: false, maxError: -1 });
    expect(compareLine(line({ error: 'vector', relative: true }), broken).pass).toBe(false);
  }
});
