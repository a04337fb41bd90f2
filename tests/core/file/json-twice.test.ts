import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readJson } from '../../../src/core/file/fault.ts';
import { jsonTwice } from '../../../src/core/file/json-twice.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';

const publicFile = (name: string): string => readFileSync(join(import.meta.dirname, '../../../public', name), 'utf8');

describe('a key that stands twice', () => {
  test.each([
    ['{"a":1,"a":2}', 'a'],
    ['{"tree":{"scale":13,"shape":7,"scale":14}}', 'tree.scale'],
    ['{"levels":[{"curve":1},{"taper":1},{"curve":1,"x":[{"curve":2}],"curve":1}]}', 'levels[2].curve'],
    ['{"a":{"b":1},"c":[1,{"a":{}}],"a":2}', 'a'],
    ['{"caf\\u00e9":1,"café":2}', 'café'],
    ['[[{"\\n":1, "\\n" : 2}]]', '[0][0].\\u000a'],
    ['{"__proto__":1,"__proto__":2}', '__proto__'],
    ['{"a":"b\\"c:{","a":1}', 'a'],
  ])('%s', (text, path) => {
    expect(jsonTwice(text)).toBe(path);
  });

  test.each([
    '{"a":"a","b":"a"}',
    '[{"a":1},{"a":1}]',
    '{"a":{"a":{"a":"a"}}}',
    '{"a:":1,"a":[",","a","a"]}',
    '"a"',
    '7',
  ])('there is none in %s', (text) => {
    expect(jsonTwice(text)).toBeUndefined();
  });

  test('there is none in what JSON.stringify writes, and in no file that ships', () => {
    fc.assert(
      fc.property(fc.json(), (json) => {
        expect(jsonTwice(JSON.stringify(JSON.parse(json)))).toBeUndefined();
      }),
    );
    for (const file of ['species/quaking-aspen.json', 'winds/recorded.json', 'winds/index.json', 'species/index.json'])
      expect(jsonTwice(publicFile(file)), file).toBeUndefined();
  });

  test('is a fault of a file, however deep', () => {
    const text = publicFile('species/quaking-aspen.json').replace('"shape": 7,', '"shape": 7, "shape": 3,');
    expect(parseSpecies(text).faults).toEqual([
      { path: 'tree.shape', found: 'the key twice', allowed: 'one of the two' },
    ]);
    const deep = `${'[{"a":'.repeat(100_000)}1${'}]'.repeat(100_000)}`;
    expect(readJson(deep, 'a species', 1e6).fault).toBeUndefined();
  });
});
