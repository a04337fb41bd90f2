import { expect, test } from 'vitest';
import { countPlaywright, countVitest } from '../reports.mjs';

const file = (status: string, assertions: number) => ({ status, assertionResults: Array(assertions).fill({}) });

test('vitest: tests are counted, and a file that could not be loaded is a failure', () => {
  const counts = { numPassedTests: 7, numFailedTests: 2, numPendingTests: 1, numTodoTests: 1 };
  const testResults = [file('passed', 7), file('failed', 4), file('failed', 0)];
  expect(countVitest({ ...counts, testResults })).toEqual({ passed: 7, failed: 3, skipped: 2 });
});

test('Playwright: a test that passed at the second try has failed, and so has a server that did not start', () => {
  const stats = { expected: 5, unexpected: 1, flaky: 1, skipped: 3 };
  expect(countPlaywright({ stats, errors: [] })).toEqual({ passed: 5, failed: 2, skipped: 3 });
  const none = { expected: 0, unexpected: 0, flaky: 0, skipped: 0 };
  expect(countPlaywright({ stats: none, errors: [{ message: 'webServer' }] })).toEqual({
    passed: 0,
    failed: 1,
    skipped: 0,
  });
});
