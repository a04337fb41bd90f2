import { expect, test } from 'vitest';
import { oneLine } from '../../../src/core/file/one-line.ts';

test.each([
  ['plain Łąka <b> 🌳', 'plain Łąka <b> 🌳'],
  ['two\nlines\r\n', 'two\\u000alines\\u000d\\u000a'],
  ['\u001b[31mred', '\\u001b[31mred'],
  ['right\u202eleft\u2028', 'right\\u202eleft\\u2028'],
  ['y'.repeat(41), `${'y'.repeat(40)}…`],
])('%j is shown on one line', (text, shown) => {
  expect(oneLine(text)).toBe(shown);
});
