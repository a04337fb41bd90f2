import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { editSpecies, editsBetween, mayBe, PLACES, valueAt, withEdit } from '../../../src/core/species/edits.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { roundValue } from '../../../src/core/species/round-value.ts';
import { treeNameOf } from '../../../src/core/species/tree-name.ts';
import { names, shipped } from '../grow/species.ts';
import { anyEdits } from './any-edits.ts';

const aspen = shipped('quaking-aspen');

describe('edits of a species', () => {
  test('give a species that a file may be, and come back from it', () => {
    fc.assert(
      fc.property(fc.constantFrom(...names), anyEdits, (name, edits) => {
        const base = shipped(name);
        const before = structuredClone(base);
        const edited = editSpecies(base, edits);
        expect(base).toEqual(before);
        expect(parseSpecies(edited)).toEqual({ species: edited });
        expect(parseSpecies(JSON.stringify(edited))).toEqual({ species: edited });
        for (const path of Object.keys(edits)) expect(valueAt(edited, path), path).toEqual(edits[path]);
        expect(editSpecies(base, editsBetween(base, edited))).toEqual(edited);
      }),
    );
  });

  test('of a level that a file does not list add it as the last one is', () => {
    const short = { ...aspen, levels: aspen.levels.slice(0, 2) };
    const edited = editSpecies(short, { 'levels.3.curve': 7 });
    expect(edited.levels.slice(0, 2)).toEqual(short.levels);
    expect(edited.levels.slice(2)).toEqual([short.levels[1], { ...short.levels[1], curve: 7 }]);
  });

  test('are none where the value is that of the species; they stand in the order of the table', () => {
    let edits = withEdit(aspen, {}, 'bark.colour', '#000000');
    edits = withEdit(aspen, edits, 'wind.stiffness', [1, 2]);
    edits = withEdit(aspen, edits, 'tree.scale', 20);
    expect(Object.keys(edits)).toEqual(['tree.scale', 'bark.colour', 'wind.stiffness']);
    edits = withEdit(aspen, edits, 'tree.scale', aspen.tree.scale);
    edits = withEdit(aspen, edits, 'wind.stiffness', [...aspen.wind.stiffness]);
    expect(edits).toEqual({ 'bark.colour': '#000000' });
  });

  test.each([
    ['tree.scale', '13'],
    ['tree.scale', null],
    ['tree.scale', Number.NaN],
    ['tree.levels', 2.5],
    ['tree.__proto__', 1],
    ['__proto__', {}],
    ['levels.4.curve', 1],
    ['levels.0.nothing', 1],
    ['bark.kind', 'toString'],
  ])('%s may not be %j', (path, value) => {
    expect(mayBe(path, value)).toBe(false);
  });
});

describe('what is kept of a value', () => {
  test('is two digits finer than a slider, and what is allowed stays so', () => {
    const scale = PLACES.get('tree.scale')!.parameter;
    expect(roundValue(scale, 0.1 + 0.2)).toBe(0.3);
    expect(roundValue(scale, 12.34567)).toBe(12.346);
    expect(Object.is(roundValue(PLACES.get('levels.1.curve')!.parameter, -1e-9), 0)).toBe(true);
    fc.assert(
      fc.property(anyEdits, (edits) => {
        for (const [path, value] of Object.entries(edits)) {
          const { parameter } = PLACES.get(path)!;
          const rounded = roundValue(parameter, value);
          expect(mayBe(path, rounded), path).toBe(true);
          expect(roundValue(parameter, rounded)).toEqual(rounded);
        }
      }),
    );
  });
});

describe('the name of a tree', () => {
  test.each([
    ['  Old   oak \n', 'Old oak'],
    ['', null],
    [' \u0000\u202e ', null],
    ['x'.repeat(200), 'x'.repeat(80)],
    ['\ud83c', null],
    [`${'x'.repeat(79)}🌳`, 'x'.repeat(79)],
  ])('%j', (text, name) => {
    expect(treeNameOf(text)).toBe(name);
  });

  test('is one that a file may have', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary', maxLength: 200 }), (text) => {
        const name = treeNameOf(text);
        if (name === null) return;
        expect(treeNameOf(name)).toBe(name);
        expect(parseSpecies({ ...aspen, name }).faults).toBeUndefined();
        expect(() => encodeURIComponent(name)).not.toThrow();
      }),
    );
  });
});
