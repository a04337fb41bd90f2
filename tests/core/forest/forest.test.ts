import '../../random-seed.ts';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { parseIndex } from '../../../src/core/file/shipped-index.ts';
import { DEFAULT_FOREST } from '../../../src/core/forest/default-forest.ts';
import { densityAt, forestDensity } from '../../../src/core/forest/density.ts';
import type { ForestDocument } from '../../../src/core/forest/forest.ts';
import { decodeForest, encodeForest } from '../../../src/core/forest/forest-link.ts';
import {
  CAMERA_NUMBERS,
  CLEARING_NUMBERS,
  FOREST_NUMBERS,
  HABITAT_NUMBERS,
  HILLS_NUMBERS,
  MAP_NUMBERS,
} from '../../../src/core/forest/forest-numbers.ts';
import { forestWind, windSpeedOf } from '../../../src/core/forest/forest-wind.ts';
import { heightAt } from '../../../src/core/forest/height-field.ts';
import { parseForest, roundForest } from '../../../src/core/forest/parse-forest.ts';
import { scatter } from '../../../src/core/forest/scatter.ts';
import { forestField } from '../../../src/core/forest/terrain.ts';
import { STAGES } from '../../../src/core/link/document.ts';
import type { NumberRule } from '../../../src/core/link/rule.ts';
import { SEASONS } from '../../../src/core/species/season.ts';
import { shippedWind, windNames } from '../wind/shipped-winds.ts';

const folder = join(import.meta.dirname, '../../../public');
const json = (path: string): unknown => JSON.parse(readFileSync(join(folder, path), 'utf8'));
const ids = (path: string): string[] => parseIndex(json(path)).entries!.map(({ id }) => id);
const shipped = { species: ids('species/index.json'), winds: windNames };
const HEAD = { format: 'windgrove-forest', version: 1, mix: [{ species: 'cherry', share: 1 }] };

describe('a forest file', () => {
  test.each([
    ['nothing', [], /The file: found the list \[\]; allowed: an object/],
    [
      'of another kind',
      { format: 'windgrove-wind' },
      /format: found the text "windgrove-wind"; allowed: "windgrove-forest"/,
    ],
    ['with too many trees', { ...HEAD, count: 20_001 }, /count: found 20001; allowed: a whole number from 1 to 20000/],
    ['too small', { ...HEAD, size: 99 }, /size: found 99; allowed: a whole number from 100 to 4000 m/],
    ['too dense', { ...HEAD, spacing: 0.5 }, /spacing: found 0.5; allowed: a number from 1 to 100 m/],
    ['with a budget of 0', { ...HEAD, budget: 0 }, /budget: found 0; allowed: a number from 8 to 200 ms/],
    ['without a mix', { ...HEAD, mix: [] }, /mix: found the list \[\]; allowed: a list of 1 to 8 species/],
    [
      'of an unknown tree',
      { ...HEAD, mix: [{ species: 'elm' }] },
      /mix\[0\]\.species: found the text "elm"; allowed: one of /,
    ],
    ['of one tree twice', { ...HEAD, mix: [...HEAD.mix, ...HEAD.mix] }, /mix\[1\]\.species: found the text "cherry"/],
    ['without a share', { ...HEAD, mix: [{ species: 'cherry', share: 0 }] }, /mix: found no share above 0/],
    [
      'with a habitat inside out',
      { ...HEAD, mix: [{ species: 'cherry', where: { slope: { least: 20, most: 10 } } }] },
      /mix\[0\]\.where\.slope\.most: found 10; allowed: at least .* 20/,
    ],
    [
      'with a misspelt key',
      { ...HEAD, terrain: { releif: 3 } },
      /terrain\.releif: found an unknown key; allowed: "relief"/,
    ],
    ['with half a camera', { ...HEAD, camera: { x: 1, y: 2 } }, /camera\.z: found nothing; allowed: a number/],
    ['of broken JSON', '{"format": "windgrove-forest",}', /broken JSON at line 1/],
  ])('%s gives a fault that says where, what and what is allowed', (_, file, message) => {
    const { forest, faults } = parseForest(file, shipped);
    expect(forest).toBeUndefined();
    expect(faults!.map(faultText).join('\n')).toMatch(message);
  });

  test('has defaults for what it leaves out', () => {
    expect(parseForest(HEAD, shipped).forest).toEqual({ ...DEFAULT_FOREST, mix: HEAD.mix });
  });
});

describe('the scenes that ship', () => {
  test.each(ids('forests/index.json'))('%s: full of trees, its eye over them or in a clearing', (id) => {
    const { forest, faults } = parseForest(json(`forests/${id}.json`), shipped);
    expect(faults?.map(faultText)).toBeUndefined();
    const field = forestField(forest!, null);
    const density = forestDensity(forest!, null);
    const places = scatter(forest!, field, density);
    expect(places.count).toBe(forest!.count);
    const kinds = forest!.mix.map((_, i) => places.species.filter((s) => s === i).length / places.count);
    expect(Math.min(...kinds)).toBeGreaterThan(0.01);
    const { x, y, z } = forest!.camera!;
    const up = z - heightAt(field, x, y);
    expect(up).toBeGreaterThan(1.6);
    // Higher than any of them grows, or where none stands.
    if (up < 25) expect(densityAt(density, x, y)).toBe(0);
    expect(roundForest(forest!)).toEqual(forest);
  });
});

const numberOf = ({ min, max, decimals, wraps }: NumberRule): fc.Arbitrary<number> => {
  const scale = 10 ** decimals;
  return fc.integer({ min: min * scale, max: max * scale - (wraps ? 1 : 0) }).map((value) => value / scale);
};
const partOf = <Key extends string>(rules: Readonly<Record<Key, NumberRule>>): fc.Arbitrary<Record<Key, number>> =>
  fc.record(
    Object.fromEntries(Object.entries<NumberRule>(rules).map(([key, rule]) => [key, numberOf(rule)])),
  ) as fc.Arbitrary<Record<Key, number>>;
const rangeOf = (rule: NumberRule) =>
  fc
    .tuple(numberOf(rule), numberOf(rule), numberOf({ ...rule, min: 0 }))
    .map(([a, b, soft]) => ({ least: Math.min(a, b), most: Math.max(a, b), soft }));
const name = fc.string({ unit: 'grapheme', minLength: 1, maxLength: 20 }).filter((text) => text.trim() !== '');
const species = fc.record(
  {
    species: fc.constantFrom(...shipped.species),
    share: numberOf({ label: '', unit: '', min: 0.001, max: 1, decimals: 3 }),
    where: fc.record(
      {
        altitude: rangeOf(HABITAT_NUMBERS.altitude),
        slope: rangeOf(HABITAT_NUMBERS.slope),
        wetness: rangeOf(HABITAT_NUMBERS.wetness),
      },
      { requiredKeys: [] },
    ),
  },
  { requiredKeys: ['species', 'share'] },
);
const { hour, windSpeed, ...plain } = FOREST_NUMBERS;
const anyForest: fc.Arbitrary<ForestDocument> = fc
  .tuple(
    partOf(plain),
    fc.record({
      name,
      hour: fc.option(numberOf(hour)),
      windSpeed: fc.option(numberOf(windSpeed)),
      mix: fc.uniqueArray(species, { minLength: 1, maxLength: 8, selector: (entry) => entry.species }),
      season: fc.constantFrom(...SEASONS),
      stage: fc.constantFrom(...STAGES),
      wind: fc.constantFrom(...shipped.winds),
      terrain: fc.oneof(
        partOf(HILLS_NUMBERS).map((hills) => ({ kind: 'hills' as const, ...hills })),
        fc.tuple(name, partOf(MAP_NUMBERS)).map(([of, heights]) => ({ kind: 'map' as const, name: of, ...heights })),
      ),
      density: fc.oneof(
        partOf(CLEARING_NUMBERS).map((clearings) => ({ kind: 'clearings' as const, ...clearings })),
        name.map((of) => ({ kind: 'map' as const, name: of })),
      ),
      camera: fc.option(partOf(CAMERA_NUMBERS)),
    }),
  )
  .map(([numbers, rest]) => ({ ...numbers, ...rest }))
  // A habitat without ranges is none.
  .map((forest) => ({
    ...forest,
    mix: forest.mix.map(({ where, ...entry }) =>
      where && Object.keys(where).length > 0 ? { ...entry, where } : entry,
    ),
  }));

describe('the link of a forest', () => {
  test('gives the document back, and says which pictures it has not', () => {
    fc.assert(
      fc.property(anyForest, (forest) => {
        const { document, faults, missing } = decodeForest(encodeForest(forest), DEFAULT_FOREST, shipped);
        expect(faults).toEqual([]);
        expect(document).toEqual(forest);
        const pictures = [forest.terrain, forest.density].flatMap((part) => (part.kind === 'map' ? [part.name] : []));
        expect(missing).toEqual(pictures);
      }),
    );
  });

  test('takes what is right and reports the rest, whatever stands there', () => {
    const { document, faults } = decodeForest(
      '#trees=50&gap=0&wnid=gale&wind=gale&mix=cherry:0.5:q1_2_3&hills=1,2&cam=1,2,3,400,5',
      DEFAULT_FOREST,
      shipped,
    );
    expect(document).toEqual({ ...DEFAULT_FOREST, count: 50, wind: 'gale' });
    expect(faults.map(({ key }) => key).sort()).toEqual(['cam', 'gap', 'hills', 'mix', 'wnid']);
    expect(faults.find(({ key }) => key === 'wnid')!.allowed).toBe('wind, if that was meant');
    fc.assert(fc.property(fc.string(), (text) => void decodeForest(text, DEFAULT_FOREST, shipped)));
  });
});

test('a wind is brought to a speed and turned as a whole', () => {
  for (const id of ['breeze', 'gusty-afternoon', 'recorded', 'sway-1995']) {
    const wind = shippedWind(id);
    const turned = forestWind(wind, 9, 90);
    expect(windSpeedOf(turned), id).toBeCloseTo(9, 6);
    const [wave] = wind.waves;
    if (wave) expect(forestWind(turned, windSpeedOf(wind), -90).waves[0]!.direction).toBeCloseTo(wave.direction);
    expect(forestWind(wind, null, 0)).toBe(wind);
  }
  expect(windSpeedOf(forestWind(shippedWind('still'), 9, 0))).toBe(0);
});
