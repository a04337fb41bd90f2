import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { jsonFault } from '../../../src/core/file/json-fault.ts';

describe('the place of a fault in JSON', () => {
  test.each([
    ['{"a": 1,}', 8],
    ['[1 2]', 3],
    ['[1,]', 3],
    ['{"a" 1}', 5],
    ['{a: 1}', 1],
    ['{"a": 01}', 7],
    ['{"a": "b\n"}', 6],
    ['{"a": tru}', 6],
    ['[]]', 2],
    ['[1}', 2],
    ['{]', 1],
    ["{'a': 1}", 1],
    ['1 // one', 2],
  ])('%j', (input, index) => {
    expect(() => JSON.parse(input)).toThrow();
    expect(jsonFault(input)).toBe(index);
  });

  test('there is none in what JSON.parse takes', () => {
    fc.assert(
      fc.property(fc.json(), (json) => {
        expect(jsonFault(json)).toBe(json.length);
      }),
    );
    for (const file of ['species/quaking-aspen.json', 'winds/recorded.json', 'winds/index.json']) {
      const text = readFileSync(join(import.meta.dirname, '../../../public', file), 'utf8');
      expect(jsonFault(text)).toBe(text.length);
    }
  });
});
