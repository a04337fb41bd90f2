import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { roundEdits } from '../../../src/core/link/encode-edits.ts';
import {
  ALL_LEVELS,
  OWN_WIND,
  roundCamera,
  roundTime,
  roundWind,
  STAGES,
  VIEW_MODES,
} from '../../../src/core/link/link.ts';
import { MOST_SNAPSHOTS } from '../../../src/core/project/limits.ts';
import { type Project, parseProject, projectText } from '../../../src/core/project/project.ts';
import type { ProjectDocument } from '../../../src/core/project/project-document.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import { SEASONS } from '../../../src/core/species/season.ts';
import { folder } from '../grow/species.ts';
import { anyEdits } from '../species/any-edits.ts';
import { anyWind } from '../wind/any-winds.ts';
import { shippedWind } from '../wind/shipped-winds.ts';

const species = parseSpecies(readFileSync(join(folder, 'quaking-aspen.json'), 'utf8')).species!;
const gale = roundWind(shippedWind('gale'));

const document: ProjectDocument = {
  treeName: 'Old one by the gate',
  edits: { 'levels.1.downAngle': 45, 'bark.colour': '#abc123' },
  seed: 7,
  wind: roundWind(shippedWind('breeze')),
  preset: 'breeze',
  blowing: true,
  compare: { layout: 'side', at: 0.25, preset: 'gale', wind: gale },
  view: 'levels',
  levelsShown: 2,
  showLeaves: false,
  season: 'autumn',
  stage: 'golden',
  hour: 18.5,
  overlays: { arrows: true, fronts: false, handle: true },
  probe: 12,
  camera: { azimuth: 30, elevation: 5, distance: 20, target: [0, 6, 0] },
  time: 12.5,
  paused: true,
  rate: 0.25,
};
const project: Project = {
  species,
  preset: 'quaking-aspen',
  document,
  snapshots: [{ name: 'Before the storm', when: 1_700_000_000_000, link: 's=quaking-aspen&seed=3' }],
};
const text = projectText(project);

const faultsOf = (file: unknown): string[] => parseProject(file).faults?.map(faultText) ?? [];

/** The file with the value at a path replaced; undefined takes the key away. */
function changed(path: string, value: unknown): unknown {
  const file = JSON.parse(text) as Record<string, unknown>;
  const keys = path.split(/\.(?![^[]*\])/);
  let at = file;
  for (const key of keys.slice(0, -1)) at = at[key] as Record<string, unknown>;
  if (value === undefined) delete at[keys.at(-1)!];
  else at[keys.at(-1)!] = value;
  return file;
}

describe('a project file', () => {
  it('gives back what was written', () => {
    expect(parseProject(text)).toEqual({ project });
    expect(parseProject(`\ufeff${text}`)).toEqual({ project });
  });

  it('is written for people: short lists and waves on a line each', () => {
    const lines = text.split('\n');
    expect(lines[1]).toBe('  "format": "windgrove-project",');
    expect(text).toContain('"camera": {\n    "azimuth": 30,');
    expect(text).toContain('"target": [ 0, 6, 0 ]');
    expect(lines.filter((line) => line.includes('"amplitude"')).every((line) => line.includes('"phase"'))).toBe(true);
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThan(700);
  });

  it('may leave out all but the species', () => {
    const bare = { format: 'windgrove-project', version: 1, species };
    expect(parseProject(bare).project).toMatchObject({
      preset: null,
      snapshots: [],
      document: {
        treeName: null,
        edits: {},
        seed: 1,
        preset: OWN_WIND,
        compare: null,
        levelsShown: ALL_LEVELS,
        camera: null,
        probe: null,
        paused: false,
      },
    });
  });

  it('holds a measured wind whole', () => {
    const record = { name: 'A mast', step: 0.5, speed: [1, 2.5, 3], direction: [0, Math.PI / 2, Math.PI] };
    const measured = { ...project, document: { ...document, wind: { ...document.wind, record } } };
    expect(parseProject(projectText(measured))).toEqual({ project: measured });
  });

  test('gives back any document', () => {
    // Directions that are no whole digits of degrees come back but for the last bit: tests/core/wind has those.
    const wind = anyWind.map((any) => ({ ...roundWind(any), record: null }));
    const anyDocument: fc.Arbitrary<ProjectDocument> = fc.record({
      treeName: fc.option(fc.constantFrom('Oak', 'Łąka 🌳')),
      edits: anyEdits.map(roundEdits),
      seed: fc.nat(),
      wind,
      preset: fc.constantFrom('breeze', OWN_WIND),
      blowing: fc.boolean(),
      compare: fc.option(
        fc.record({
          layout: fc.constantFrom('split' as const, 'side' as const),
          at: fc.integer({ min: 0, max: 1000 }).map((at) => at / 1000),
          preset: fc.constant(OWN_WIND),
          wind,
        }),
      ),
      view: fc.constantFrom(...VIEW_MODES),
      levelsShown: fc.integer({ min: 1, max: 9 }),
      showLeaves: fc.boolean(),
      season: fc.constantFrom(...SEASONS),
      stage: fc.constantFrom(...STAGES),
      hour: fc.option(fc.integer({ min: 0, max: 96 }).map((quarter) => quarter / 4)),
      overlays: fc.record({ arrows: fc.boolean(), fronts: fc.boolean(), handle: fc.boolean() }),
      probe: fc.option(fc.nat(), { nil: null }),
      camera: fc.option(
        fc
          .record({
            azimuth: fc.double({ min: 0, max: 359, noNaN: true }),
            elevation: fc.double({ min: -90, max: 90, noNaN: true }),
            distance: fc.double({ min: 1, max: 100, noNaN: true }),
            target: fc.constant([1.5, -2, 0.25] as const),
          })
          .map(roundCamera),
        { nil: null },
      ),
      time: fc.double({ min: 0, max: 1000, noNaN: true }).map(roundTime),
      paused: fc.boolean(),
      rate: fc.constantFrom(0.1, 1, 2),
    });
    fc.assert(
      fc.property(anyDocument, (any) => {
        expect(parseProject(projectText({ ...project, document: any })).project?.document).toEqual(any);
      }),
      { numRuns: 60 },
    );
  });
});

describe('one fault, at its path, with what was found and what is allowed', () => {
  test.each([
    ['format', 'windgrove-species', 'format: found the text "windgrove-species"; allowed: "windgrove-project".'],
    ['version', 2, 'version: found 2; allowed: 1, the only version so far.'],
    ['sede', 7, 'sede: found an unknown key; allowed: "seed".'],
    ['species', undefined, 'species: found nothing; allowed: an object.'],
    ['species', text, /^species: found the text ".*"; allowed: an object\.$/],
    ['species.tree.scale', -1, 'species.tree.scale: found -1; allowed: a number from 0.05 to 150 metres.'],
    ['species.levels', 'many', /^species\.levels: found the text "many"/],
    ['edits', [], 'edits: found the list []; allowed: an object.'],
    [
      'edits',
      { 'levels.1.downAngel': 4 },
      'edits.levels.1.downAngel: found an unknown key; allowed: "levels.1.downAngle".',
    ],
    [
      'edits',
      { 'tree.scale': 'tall' },
      'edits.tree.scale: found the text "tall"; allowed: a number from 0.05 to 150 metres.',
    ],
    ['seed', 1.5, 'seed: found 1.5; allowed: a whole number from 0 to 4294967295.'],
    ['seed', '7', 'seed: found the text "7"; allowed: a whole number from 0 to 4294967295.'],
    ['name', ' ', 'name: found the text " "; allowed: a name of 1 to 80 letters, or null.'],
    ['wind', 'breeze', /^wind: found .*; allowed: an object\.$/],
    ['wind.strength', 2, 'wind.strength: found 2; allowed: a number from 0 to 1.'],
    ['wind.record', 'mast.csv', 'wind: found an object; allowed: a wind with its record in it.'],
    ['windPreset', 5, 'windPreset: found 5; allowed: a text of 1 to 80 characters.'],
    ['compare.layout', 'over', 'compare.layout: found the text "over"; allowed: "split", "side".'],
    ['compare.wind.model', 'jelly', /^compare\.wind\.model: /],
    ['blowing', 1, 'blowing: found 1; allowed: true or false.'],
    ['view.mode', 'pretty', 'view.mode: found the text "pretty"; allowed: "shaded", "wireframe", "control", "levels".'],
    ['view.levels', 0, 'view.levels: found 0; allowed: a whole number from 1 to 9.'],
    ['camera.distance', undefined, 'camera.distance: found nothing; allowed: a number.'],
    ['camera.target', [1, 2], 'camera.target: found the list [1, 2]; allowed: a list of 3 numbers.'],
    ['rate', Number.NaN, 'rate: found NaN; allowed: a number from 0.1 to 2 ×.'],
    ['snapshots', {}, `snapshots: found an object; allowed: a list of up to ${MOST_SNAPSHOTS} snapshots.`],
    ['snapshots', [{ name: 'x', when: 1 }], 'snapshots[0].link: found nothing; allowed: a text.'],
  ])('%s = %j', (path, value, says) => {
    const faults = faultsOf(changed(path, value));
    expect(faults).toHaveLength(1);
    if (typeof says === 'string') expect(faults[0]).toBe(says);
    else expect(faults[0]).toMatch(says);
  });

  it.each([
    ['', 'an empty file'],
    ['{"format": "windgrove-project"', 'broken JSON'],
    ['[]', 'the list []'],
  ])('%j is no project', (file, found) => {
    expect(faultsOf(file)).toHaveLength(1);
    expect(faultsOf(file)[0]).toContain(found);
  });

  it('whatever stands in the file', () => {
    fc.assert(
      fc.property(fc.constantFrom(...Object.keys(JSON.parse(text) as object)), fc.anything(), (key, value) => {
        const { project: read, faults } = parseProject({ ...(JSON.parse(text) as object), [key]: value });
        expect(read === undefined).toBe(faults !== undefined && faults.length > 0);
      }),
      { numRuns: 500 },
    );
  });
});
