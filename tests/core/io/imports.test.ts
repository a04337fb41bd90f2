import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { GrowthBudgetError } from '../../../src/core/grow/budget.ts';
import { grow } from '../../../src/core/grow/grow.ts';
import { NothingGrownError } from '../../../src/core/grow/nothing-grown.ts';
import { parseArbaro } from '../../../src/core/io/arbaro.ts';
import { parseEzTree } from '../../../src/core/io/ez-tree.ts';
import { type Imported, isArbaro, isEzTree } from '../../../src/core/io/imported.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { ARBARO, arbaroWith, EZ_TREE } from './import-samples.ts';

/** The species and the notes of a file that must be good. */
function good(imported: Imported): { species: Species; notes: string } {
  if (imported.faults) throw new Error(imported.faults.map(({ path, found }) => `${path}: ${found}`).join('\n'));
  return { species: imported.species, notes: imported.notes.join('\n') };
}

type Change = (tree: typeof EZ_TREE) => void;

const ezTreeWith = (change: Change): string => {
  const tree = structuredClone(EZ_TREE);
  change(tree);
  return JSON.stringify(tree);
};

describe('a tree of Arbaro', () => {
  test('is told from other files', () => {
    expect([ARBARO, JSON.stringify(EZ_TREE), '<svg/>', '{}', ''].map(isArbaro)).toEqual([
      true,
      false,
      false,
      false,
      false,
    ]);
  });

  test('becomes the species that its numbers say', () => {
    const { species, notes } = good(parseArbaro(ARBARO));
    expect(species.name).toBe('Garden apple');
    expect(species.tree).toMatchObject({ shape: 1, levels: 3, scale: 5.5, scaleV: 0.5, baseSize: 0.25, ratio: 0.025 });
    expect(species.tree).toMatchObject({ ratioPower: 1.3, lobes: 3, lobeDepth: 0.05, flare: 0.4, attractionUp: 0.3 });
    expect(species.levels[0]).toMatchObject({ length: 0.9, baseSplits: 1, segSplits: 0.2, scaleV: 0.1, curveV: 60 });
    expect(species.levels[1]).toMatchObject({ downAngle: 55, downAngleV: -20, branches: 22, length: 0.45, curve: -25 });
    expect(species.levels[2]).toMatchObject({ rotate: 137, branches: 14, curveRes: 4 });
    expect(species.leaves).toMatchObject({ count: 12, shape: 0, scale: 0.09, scaleX: 0.7, petiole: 0.4, bend: 0.2 });
    expect(notes.split('\n')).toEqual([
      'Left out, since Windgrove has nothing of the kind: Smooth 0.5, LeafDistrib 4.',
      expect.stringContaining('bark, leaves and the answer to the wind have plain values'),
    ]);
  });

  test('grows, and is a species file of ours', () => {
    const { species } = good(parseArbaro(ARBARO));
    expect(parseSpecies(JSON.stringify(species)).species).toEqual(species);
    const { stats } = growPacked(species, 3);
    expect(stats.height).toBeGreaterThan(4);
    expect(stats.height).toBeLessThan(7);
    expect(stats.levels.map(({ stems }) => stems > 0)).toEqual([true, true, true]);
    expect(stats.leaves).toBeGreaterThan(500);
  });

  test('with several trunks, a fan of leaves, and numbers beyond our ranges says what became of them', () => {
    const text = arbaroWith("'0Branches' value='1'", "'0Branches' value='3'")
      .replace("'Leaves' value='12'", "'Leaves' value='-7'")
      .replace("'Lobes' value='3'", "'Lobes' value='2.6'")
      .replace("'1CurveRes' value='7'", "'1CurveRes' value='500'");
    const { species, notes } = good(parseArbaro(text));
    expect(species.levels[0]?.branches).toBe(3);
    expect(species.leaves.count).toBe(-7);
    expect(species.tree.lobes).toBe(3);
    expect(notes).toContain('levels.1.curveRes 500 became 200');
    expect(notes).toContain('tree.lobes 2.6 became 3');
  });

  test('names what nobody knows, and takes the first of several species', () => {
    const text = arbaroWith("<param name='Shape'", "<param name='Glitter' value='1'/><param name='Shape'").replace(
      '</arbaro>',
      "<species name='B'/></arbaro>",
    );
    const { species, notes } = good(parseArbaro(text.replace("'LeafShape' value='0'", "'LeafShape' value='palm'")));
    expect(species.name).toBe('Garden apple');
    expect(notes).toContain('nobody knows them: Glitter.');
    expect(notes).toContain('The file has 1 more species');
    expect(notes).toContain('Leaves of the shape "palm" became ovals.');
  });

  test.each([
    ['', '', 'an empty file'],
    ['hello', '', 'broken XML at line 1, column 1'],
    [ARBARO.slice(0, 700), '', expect.stringMatching(/^broken XML at line \d+, column \d+$/)],
    ['<forest/>', '', 'the element <forest>'],
    ['<arbaro/>', 'arbaro', 'no <species>'],
    ['<arbaro><species name="A"/></arbaro>', 'species', 'no <param>'],
    [arbaroWith("'Scale' value='5.5'", "'Scale' value='tall'"), 'Scale', 'the text "tall"'],
    [arbaroWith("'1Length' value='0.45'", "'1Length' value='1e999'"), '1Length', 'the text "1e999"'],
    [arbaroWith("name='Shape' ", ''), 'param', 'no name'],
    ['<!DOCTYPE a [<!ENTITY x "y">]><arbaro><species name="&x;"/></arbaro>', '', expect.stringContaining('broken XML')],
  ])('that is %#: not one ends with a fault', (text, path, found) => {
    expect(parseArbaro(text).faults?.[0]).toEqual({ path, found, allowed: expect.stringMatching(/./) });
  });
});

describe('a tree of ez-tree', () => {
  const text = JSON.stringify(EZ_TREE);

  test('is told from other files', () => {
    const ours = JSON.stringify({ format: 'windgrove-species', branch: {} });
    expect([text, ARBARO, ours, '{"branch": ', '[]'].map(isEzTree)).toEqual([true, false, false, false, false]);
  });

  test('becomes a species of as many levels and stems, and about as high', () => {
    const imported = parseEzTree(text);
    const { species, notes } = good(imported);
    expect(imported.seed).toBe(4711);
    expect(species.name).toBe('Aspen from ez-tree');
    const all = [1, 2, 3, 4, 5].map((seed) => growPacked(species, seed).stats);
    // ez-tree: a trunk, 9 branches and one that goes on, and on each of them 5 and one that goes on.
    const mean = (level: number): number => all.reduce((sum, { levels }) => sum + (levels[level]?.stems ?? 0) / 5, 0);
    expect([mean(0), Math.round(mean(1)), mean(3)]).toEqual([1, 10, 0]);
    expect(Math.abs(mean(2) - 60)).toBeLessThan(4);
    // 34 units of trunk and 22 that it goes on for, of which wandering leaves a part.
    for (const { height } of all) {
      expect(height).toBeGreaterThan(0.25 * 38);
      expect(height).toBeLessThan(0.25 * 58);
    }
    expect(species.bark).toMatchObject({ kind: 'smooth', colour: '#e4d6bb' });
    expect(species.leaves.scale).toBeCloseTo(2.2 * 0.36 * 0.25);
    for (const what of ['branch.start', 'leaves.start', 'branch.twist', 'leaves.sizeVariance', 'became 0.25 m'])
      expect(notes).toContain(what);
    expect(notes).not.toContain('nobody knows');
    expect(notes).not.toContain('trellis');
  });

  test('that is evergreen has the lengths of a cone', () => {
    const pine = ezTreeWith((tree) => {
      tree.type = 'Evergreen';
      tree.branch.levels = 1;
      tree.branch.children[0] = 60;
      tree.branch.angle[1] = 100;
      tree.leaves.type = 'pine';
    });
    const { species } = good(parseEzTree(pine));
    expect(species.tree).toMatchObject({ shape: 9, levels: 2, scale: 34 * 0.25 });
    expect(species.levels[1]).toMatchObject({ branches: 60, downAngle: 100 });
    const { stats } = growPacked(species, 1);
    expect(stats.levels[1]?.stems).toBe(60);
    expect(Math.abs(stats.height / (34 * 0.25) - 1)).toBeLessThan(0.1);
  });

  test('may leave out what ez-tree has a value for, and be a bare trunk', () => {
    const { species } = good(parseEzTree('{"branch": {"levels": 0}}'));
    expect(species.tree.levels).toBe(1);
    expect(growPacked(species, 1).stats.leaves).toBeGreaterThan(0);
    expect(good(parseEzTree('{"branch": {}}')).species.tree.levels).toBe(4);
  });

  test('names keys that nobody knows, and forces to the side', () => {
    const { notes } = good(
      parseEzTree(
        ezTreeWith((tree) => {
          Object.assign(tree, { season: 'spring', trellis: { enabled: true } });
          Object.assign(tree.branch, { thorns: 2 });
          Object.assign(tree.branch.force.direction, { x: 1 });
        }),
      ),
    );
    expect(notes).toContain('nobody knows them: branch.thorns, season.');
    expect(notes).toContain('branch.force.direction');
    expect(notes).toContain('The trellis was left out');
  });

  test.each<[Change, string, string]>([
    [(tree) => Object.assign(tree.branch.length, { 1: 'long' }), 'branch.length.1', 'the text "long"'],
    [(tree) => Object.assign(tree.branch, { levels: 9 }), 'branch.levels', '9'],
    [(tree) => Object.assign(tree.branch.children, { 0: -4 }), 'branch.children.0', '-4'],
    [(tree) => Object.assign(tree, { type: 'palm' }), 'type', 'the text "palm"'],
    [(tree) => Object.assign(tree, { leaves: [1] }), 'leaves', 'the list [1]'],
    [(tree) => Object.assign(tree.trellis, { enabled: 'no' }), 'trellis.enabled', 'the text "no"'],
    [(tree) => Object.assign(tree.bark, { tint: null }), 'bark.tint', 'null'],
  ])('that is wrong at one place says where: %#', (change, path, found) => {
    expect(parseEzTree(ezTreeWith(change)).faults).toEqual([{ path, found, allowed: expect.stringMatching(/./) }]);
  });

  test.each(['', '{"branch": ', '[]', '7', '{"seed": 1}', text.slice(0, 200)])('that is %j is no tree', (broken) => {
    expect(parseEzTree(broken).faults).toHaveLength(1);
  });
});

/** Whether a species grows, or ends with the one message that growing has for it. */
function growsOrSays(species: Species): void {
  expect(parseSpecies(JSON.stringify(species)).faults).toBeUndefined();
  try {
    const tree = grow(species, 1, { budget: { stems: 2000, leaves: 20_000, bytes: 2 ** 24 } });
    expect(tree.stems.nodePosition.every(Number.isFinite)).toBe(true);
  } catch (error) {
    if (!(error instanceof GrowthBudgetError || error instanceof NothingGrownError)) throw error;
  }
}

/** A text with parts of it changed, doubled or cut out. */
const cutUp = (text: string): fc.Arbitrary<string> =>
  fc
    .array(
      fc.record({
        at: fc.nat(text.length),
        length: fc.oneof(fc.constant(1), fc.nat(40)),
        put: fc.oneof(
          fc.constantFrom(
            '',
            '-',
            '9',
            '1e300',
            '"',
            "'",
            '<',
            '>',
            '&',
            '{',
            '}',
            ',',
            '-0',
            'null',
            '\u0000',
            'é',
            ' ',
          ),
          fc.string({ maxLength: 8 }),
          fc.nat(text.length).map((from) => text.slice(from, from + 30)),
        ),
      }),
      { minLength: 1, maxLength: 4 },
    )
    .map((cuts) => cuts.reduce((now, { at, length, put }) => now.slice(0, at) + put + now.slice(at + length), text));

/** A text with some of its numbers changed. */
const renumbered = (text: string): fc.Arbitrary<string> => {
  const count = text.match(NUMBERS)?.length ?? 0;
  const number = fc.oneof(
    fc.integer({ min: -5, max: 400 }),
    fc.double({ min: -2, max: 50, noNaN: true }),
    fc.constantFrom(0, -1, 1e9, -1e9, 1e-9, 1e300),
  );
  return fc.dictionary(fc.nat(count - 1).map(String), number, { minKeys: 1, maxKeys: 6 }).map((changes) => {
    let k = -1;
    return text.replace(NUMBERS, (was) => {
      k += 1;
      return Object.hasOwn(changes, k) ? String(changes[k]) : was;
    });
  });
};

const NUMBERS = /(?<=[':]|value=')-?\d+(?:\.\d+)?(?=[',}])/g;

const mutated = (text: string): fc.Arbitrary<string> => fc.oneof(cutUp(text), renumbered(text));

const RUNS = { numRuns: 1000 };

test.each([
  ['Arbaro', parseArbaro, ARBARO],
  ['ez-tree', parseEzTree, JSON.stringify(EZ_TREE)],
])('whatever becomes of the text of a tree of %s, it grows or has faults that say where', (_, parse, text) => {
  let grown = 0;
  fc.assert(
    fc.property(mutated(text), (broken) => {
      const { species, faults } = parse(broken);
      if (species) {
        growsOrSays(species);
        grown += 1;
      } else {
        expect(faults.length).toBeGreaterThan(0);
        for (const fault of faults) expect(`${fault.path}${fault.found}${fault.allowed}`).not.toMatch(/\p{Cc}/u);
      }
    }),
    RUNS,
  );
  // Not all of them broken: a test of one message would prove little.
  expect(grown).toBeGreaterThan(100);
});

/** Any number where ez-tree has one. */
test('whatever numbers a tree of ez-tree has, it grows or has faults', () => {
  const number = fc.oneof(
    fc.double({ noNaN: true }),
    fc.integer({ min: -10, max: 100 }),
    fc.double({ min: 0, max: 2, noNaN: true }),
  );
  const byLevel = fc.record({ 0: number, 1: number, 2: number, 3: number }, { requiredKeys: [] });
  const keys = ['angle', 'children', 'gnarliness', 'length', 'radius', 'sections', 'start', 'taper', 'twist'];
  const branch = fc.record(
    { levels: fc.integer({ min: 0, max: 3 }), ...Object.fromEntries(keys.map((key) => [key, byLevel])) },
    { requiredKeys: [] },
  );
  fc.assert(
    fc.property(branch, fc.constantFrom('deciduous', 'evergreen'), (values, type) => {
      const { species } = parseEzTree(JSON.stringify({ type, branch: values }));
      if (species) growsOrSays(species);
    }),
    RUNS,
  );
});
