import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { BARK_KINDS } from '../../../src/core/species/species.ts';
import { folder, shipped } from '../grow/species.ts';

type Json = Record<string, unknown>;
const text = readFileSync(join(folder, 'quaking-aspen.json'), 'utf8');
const faultsOf = (input: unknown) => {
  const { faults } = parseSpecies(input);
  if (!faults) throw new Error('no fault was found');
  return faults;
};

/** The aspen's file with the value at a path replaced; undefined takes the key away. */
function changed(path: string, value: unknown): Json {
  const file: Json = JSON.parse(text);
  const keys = path.split(/[.[\]]+/).filter(Boolean);
  let at: Json = file;
  for (const key of keys.slice(0, -1)) at = at[key] as Json;
  if (value === undefined) delete at[keys[keys.length - 1]];
  else at[keys[keys.length - 1]] = value;
  return file;
}

describe('one fault, at its path, with what was found and what is allowed', () => {
  test.each([
    ['tree.scale', undefined, 'nothing', 'a number from 0.05 to 150 metres'],
    ['tree.scale', Number.NaN, 'NaN', 'a number from 0.05 to 150 metres'],
    ['tree.scale', 1e300, '1e+300', 'a number from 0.05 to 150 metres'],
    ['tree.scale', Number.POSITIVE_INFINITY, 'Infinity', 'a number from 0.05 to 150 metres'],
    ['tree.scale', '13', 'the text "13"', 'a number from 0.05 to 150 metres'],
    ['tree.scale', null, 'null', 'a number from 0.05 to 150 metres'],
    ['tree.levels', 2.5, '2.5', 'a whole number from 1 to 8'],
    ['tree.shpae', 7, 'an unknown key', '"shape"'],
    ['tree', 7, '7', 'an object'],
    ['tree', [], 'the list []', 'an object'],
    ['levels', {}, 'an object', 'a list of 1 to 4 levels, the trunk first'],
    ['levels', [], 'the list []', 'a list of 1 to 4 levels, the trunk first'],
    ['levels[2]', 'thin', 'the text "thin"', 'an object'],
    ['levels[0].curveRes', -3, '-3', 'a whole number from 1 to 200'],
    ['levels[2].curveRes', 'five', 'the text "five"', 'a whole number from 1 to 200'],
    ['levels[1].segSplits', -0.5, '-0.5', 'a number from 0 to 8'],
    ['levels[3].downAngle', [45], 'the list [45]', 'a number from -360 to 360 degrees'],
    ['levels[1].branches', undefined, 'nothing', 'a number from -1000 to 100000'],
    ['leaves.count', -1e6, '-1000000', 'a number from -1000 to 10000'],
    ['pruning', undefined, 'nothing', 'an object'],
    ['switches.pruneBase', 'yes', 'the text "yes"', 'true or false'],
    ['bark.kind', 'scaly', 'the text "scaly"', BARK_KINDS.map((kind) => `"${kind}"`).join(', ')],
    ['bark.colour', '<b>red</b>', 'the text "<b>red</b>"', 'a colour as "#rrggbb"'],
    ['wind.stiffness', [1, 0], 'the list [1, 0]', 'a list of 1 to 8 numbers from 0.01 to 1000'],
    ['name', '', 'the text ""', 'a text of 1 to 80 characters'],
    ['name', ' \n', 'the text " \\u000a"', 'a text of 1 to 80 characters'],
    ['$schema', 7, '7', 'a text, the address of the schema'],
    ['format', 'windgrove-wind', 'the text "windgrove-wind"', '"windgrove-species"'],
    ['version', 2, '2', '1, the only version so far'],
  ])('%s: %j', (path, value, found, allowed) => {
    expect(faultsOf(changed(path, value))).toEqual([{ path, found, allowed }]);
  });

  test('a fault is one line whatever stands in the file: no line breaks, no colours of a terminal', () => {
    const file = { ...changed('bark.kind', 'a\nb\u001b[31m'), 'x\ny\u202e': 1 };
    expect(faultsOf(file).map(faultText)).toEqual([
      expect.stringMatching(/^x\\u000ay\\u202e: found an unknown key/),
      expect.stringMatching(/^bark\.kind: found the text "a\\u000ab\\u001b\[31m"; allowed: .*$/),
    ]);
  });

  test('unknown parts and keys are named even if they are the names of an object', () => {
    expect(faultsOf(changed('nonsense', 1))).toMatchObject([{ path: 'nonsense', found: 'an unknown key' }]);
    const file = text.replace('"shape": 7,', '"shape": 7, "__proto__": 1, "toString": 2,');
    expect(faultsOf(file).map(({ path }) => path)).toEqual(['tree.__proto__', 'tree.toString']);
  });

  test.each([
    ['', 'an empty file'],
    ['  \n', 'an empty file'],
    ['{\n  "format": }', 'broken JSON at line 2, column 13'],
    ['{"tree": {"scale": NaN}}', 'broken JSON at line 1, column 20'],
    [' '.repeat(1_000_001).replace(' ', '{'), '1000001 characters'],
    ['null', 'null'],
    ['[]', 'the list []'],
    ['"a tree"', 'the text "a tree"'],
  ])('the text %.20j', (input, found) => {
    expect(faultsOf(input)).toMatchObject([{ path: '', found }]);
  });

  test('JSON that stops too early', () => {
    expect(faultsOf('{"format":')[0].found).toBe('broken JSON that ends too early, at line 1, column 11');
  });
});

test('a byte order mark before the file is no fault', () => {
  expect(parseSpecies(`\ufeff${text}`)).toEqual(parseSpecies(text));
});

test('all faults are found at once, and read as a sentence', () => {
  const file = changed('tree.scale', -1);
  (file.levels as Json[])[3].taper = 9;
  expect(faultsOf(file).map(faultText)).toEqual([
    'tree.scale: found -1; allowed: a number from 0.05 to 150 metres.',
    'levels[3].taper: found 9; allowed: a number from 0 to 3.',
  ]);
});

test("what is Windgrove's own may be left out", () => {
  const file: Json = JSON.parse(text);
  for (const part of ['bark', 'foliage', 'wind', 'switches', 'latin', 'source']) delete file[part];
  delete (file.tree as Json).disc;
  for (const key of ['branches', 'rotate', 'downAngle']) delete (file.levels as Json[])[0][key];
  for (const key of ['scale', 'baseSplits', 'helixTurns']) delete (file.levels as Json[])[2][key];
  const { species, faults } = parseSpecies(file);
  expect(faults).toBeUndefined();
  expect(species).toMatchObject({ tree: { disc: 0.05 }, wind: { flutter: 20 }, switches: { spread: 0.75 }, latin: '' });
  expect(species?.levels[0].branches).toBe(1);
  expect(species?.levels[2]).toMatchObject({ scale: 1, baseSplits: 0, helixTurns: 0.5 });
  expect(species?.foliage).not.toHaveProperty('outline');
});

test('fewer than four levels are enough', () => {
  const file = changed('levels[3]', undefined);
  (file.levels as Json[]).length = 2;
  expect(parseSpecies(file).species?.levels).toHaveLength(2);
});

test('parsing a parsed species changes nothing', () => {
  const species = shipped('california-black-oak');
  expect(parseSpecies(species).species).toEqual(species);
  expect(parseSpecies(JSON.stringify(species)).species).toEqual(species);
});

test('no input makes it throw', () => {
  fc.assert(
    fc.property(fc.anything(), (value) => {
      expect(parseSpecies(value).faults).toBeDefined();
    }),
  );
  fc.assert(
    fc.property(fc.nat(text.length - 1), fc.string({ maxLength: 3 }), (at, replaced) => {
      parseSpecies(text.slice(0, at) + replaced + text.slice(at + replaced.length));
    }),
  );
});
