import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { loadWind } from '../../../src/core/wind/load-wind.ts';
import { parseWind } from '../../../src/core/wind/parse-wind.ts';
import { DEFAULT_GUST, DEFAULT_WAVE, STILL, type Wind } from '../../../src/core/wind/wind.ts';
import { degreesOf, windText, windToFile } from '../../../src/core/wind/wind-file.ts';

type Json = Record<string, unknown>;

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** A wind with something everywhere. */
const FULL: Wind = {
  ...STILL,
  name: 'All of it',
  description: 'Everything that a file can say.',
  waves: [DEFAULT_WAVE, { ...DEFAULT_WAVE, solo: true, direction: radians(70.73) }],
  gusts: [DEFAULT_GUST, { ...DEFAULT_GUST, start: 12.5, direction: radians(-42.5), repeat: 45 }],
  profile: { kind: 'log', height: 12, roughness: 0.03, exponent: 0.2 },
  zeroMean: true,
  stiffness: 1.5,
  spring: { frequency: 0.8, damping: 0.2, inertia: 0.4, levels: [{ frequency: null, damping: 0.3 }] },
  record: { name: 'mast {3}', step: 0.5, speed: [1, 2.5, 3], direction: [10, 11.25, -17].map(radians) },
};
const text = windText(FULL);

const faultsOf = (input: unknown) => {
  const { faults } = parseWind(input);
  if (!faults) throw new Error('no fault was found');
  return faults;
};

/** The file with the value at a path replaced; undefined takes the key away. */
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
    ['strength', 1.5, '1.5', 'a number from 0 to 1'],
    ['strength', Number.NaN, 'NaN', 'a number from 0 to 1'],
    ['zeroMean', 1, '1', 'true or false'],
    ['stiffness', 0, '0', 'a number from 0.05 to 20'],
    ['model', 'springs', 'the text "springs"', '"direct", "spring", "sway"'],
    ['pose', 'lag', 'the text "lag"', '"exact", "lagged"'],
    ['wawes', [], 'an unknown key', '"waves"'],
    ['waves', {}, 'an object', 'a list of up to 8 waves'],
    ['waves', new Array(9).fill(DEFAULT_WAVE), 'a list of 9', 'a list of up to 8 waves'],
    ['waves[1]', 4, '4', 'an object'],
    ['waves[1].wavelength', 0, '0', 'a number from 0.1 to 500 metres'],
    ['waves[1].wavelength', '20', 'the text "20"', 'a number from 0.1 to 500 metres'],
    ['waves[1].amplitude', -0.1, '-0.1', 'a number from 0 to 10 metres'],
    ['waves[0].direction', 400, '400', 'a number from -360 to 360 degrees'],
    ['waves[0].sharpnes', 2, 'an unknown key', '"sharpness"'],
    ['waves[0].on', 'yes', 'the text "yes"', 'true or false'],
    ['gusts', new Array(17).fill(DEFAULT_GUST), 'a list of 17', 'a list of up to 16 gusts'],
    ['gusts[1].rise', 0, '0', 'a number from 0.01 to 600 seconds'],
    ['gusts[1].repeat', 4, '4', '0, or at least 5 seconds: 5, and its rise and fall'],
    ['gusts[1].speed', null, 'null', 'a number from 0.1 to 100 metres a second'],
    ['profile', 'log', 'the text "log"', 'an object'],
    ['profile.kind', 'linear', 'the text "linear"', '"none", "log", "power"'],
    ['profile.height', 0.02, '0.02', 'a number from 0.1 to 1000 metres'],
    ['profile.roughness', 15, '15', 'a number from 0.0001 to 10 metres'],
    ['spring.damping', 0, '0', 'a number from 0.005 to 10'],
    ['spring.levels', new Array(5).fill({}), 'a list of 5', 'a list of up to 4 levels'],
    ['spring.levels[0].frequency', 0, '0', 'a number from 0.05 to 20 hertz, or null'],
    ['spring.level', [], 'an unknown key', '"levels"'],
    ['sway.reading', 'length', 'the text "length"', '"ratio", "cantilever"'],
    ['record', 7, '7', 'null, the name of a CSV file, or an object with name, step, speed and direction'],
    ['record', '../mast.csv', 'the text "../mast.csv"', 'the name of a CSV file beside this one, as "measured.csv"'],
    ['record.name', undefined, 'nothing', 'a text of up to 80 characters'],
    ['record.step', 0, '0', 'a number from 0.01 to 600 seconds'],
    ['record.speed', [1], 'the list [1]', 'a list of 2 to 36000 numbers from 0 to 100 metres a second'],
    ['record.speed[1]', 'x', 'the text "x"', 'a number from 0 to 100 metres a second'],
    ['record.direction', [1, 2], 'a list of 2', 'a list of 3 numbers, as many as record.speed'],
    ['name', undefined, 'nothing', 'a text of 1 to 80 characters'],
    ['description', 'x'.repeat(201), expect.stringContaining('x'), 'a text of up to 200 characters'],
    ['format', 'windgrove-species', 'the text "windgrove-species"', '"windgrove-wind"'],
    ['version', 2, '2', '1, the only version so far'],
  ])('%s: %j', (path, value, found, allowed) => {
    expect(faultsOf(changed(path, value))).toEqual([{ path, found, allowed }]);
  });

  test('the logarithmic law needs a height above its roughness; the others do not read it', () => {
    const file = changed('profile', { kind: 'log', height: 0.5, roughness: 0.5 });
    expect(faultsOf(file).map(faultText)).toEqual([
      'profile.roughness: found 0.5; allowed: less than profile.height, 0.5.',
    ]);
    expect(parseWind(changed('profile', { kind: 'power', height: 0.5, roughness: 0.5 })).faults).toBeUndefined();
  });

  test('all faults are found at once', () => {
    const file = changed('waves[0].phase', 2);
    (file.gusts as Json[])[0].fall = -1;
    expect(faultsOf(file).map(({ path }) => path)).toEqual(['waves[0].phase', 'gusts[0].fall']);
  });

  test.each([
    ['', 'an empty file', 'a wind as a JSON document'],
    ['{\n  "format": }', 'broken JSON at line 2, column 13', 'a wind as a JSON document'],
    ['[]', 'the list []', 'an object'],
  ])('the text %j', (input, found, allowed) => {
    expect(faultsOf(input)).toEqual([{ path: '', found, allowed }]);
  });
});

test('whatever a file leaves out is as in a still wind; angles are degrees', () => {
  const waves = [{ direction: 90 }];
  const file = { format: 'windgrove-wind', version: 1, name: 'Short', waves, gusts: [{}], spring: { levels: [{}] } };
  expect(parseWind(file)).toEqual({
    wind: {
      ...STILL,
      name: 'Short',
      description: '',
      waves: [{ ...DEFAULT_WAVE, direction: Math.PI / 2 }],
      gusts: [DEFAULT_GUST],
      spring: { ...STILL.spring, levels: [{ frequency: null, damping: null }] },
    },
    recordFile: null,
  });
});

describe('the file of a wind', () => {
  test('reads back as the same wind, bit for bit, and as the same text', () => {
    const { wind } = parseWind(text);
    expect(wind).toEqual(FULL);
    expect(windText(wind!)).toBe(text);
    expect(parseWind(windToFile(FULL)).wind).toEqual(FULL);
  });

  test('has a line for each wave and each gust, and every key in its order', () => {
    expect(text).toContain('\n    { "on": true, "solo": true, "amplitude": 0.05, "direction": 70.73, "wavelength": 20');
    expect(text).toContain('\n    "speed": [ 1, 2.5, 3 ],');
    expect(Object.keys(JSON.parse(text)).sort()).toEqual([...Object.keys(STILL), 'format', 'version'].sort());
  });

  test('degrees have the fewest digits that give the same direction back', () => {
    fc.assert(
      fc.property(fc.integer({ min: -360, max: 360 }), (degrees) => {
        expect(degreesOf((degrees * Math.PI) / 180)).toBe(degrees + 0);
      }),
    );
    fc.assert(
      fc.property(fc.double({ min: -6.28, max: 6.28, noNaN: true }), (radians) => {
        expect((degreesOf(radians) * Math.PI) / 180).toBeCloseTo(radians, 13);
      }),
    );
    expect(degreesOf(9 * Math.PI)).toBeCloseTo(180, 9);
  });

  test('no input makes the parser throw', () => {
    fc.assert(
      fc.property(fc.anything(), (value) => {
        expect(parseWind(value).faults).toBeDefined();
      }),
    );
    fc.assert(
      fc.property(fc.nat(text.length - 1), fc.string({ maxLength: 3 }), (at, replaced) => {
        parseWind(text.slice(0, at) + replaced + text.slice(at + replaced.length));
      }),
    );
  });
});

describe('a record in a CSV file beside', () => {
  const file = windText(FULL, 'mast.csv');

  test('is named by the file and read by the loader', async () => {
    expect(parseWind(file)).toEqual({ wind: { ...FULL, record: null }, recordFile: 'mast.csv' });
    const csv = 'time (s),speed (m/s),direction\n0,4,270\n1,5,180\n';
    const { wind, recordFile } = await loadWind(file, async (name) => (name === 'mast.csv' ? csv : ''));
    expect(recordFile).toBe('mast.csv');
    expect(wind?.record).toEqual({ name: 'All of it', step: 1, speed: [4, 5], direction: [0, Math.PI / 2] });
  });

  test('its faults have its name', async () => {
    const { faults } = await loadWind(file, async () => 'time,speed\n0,4\n1,fast\n');
    expect(faults?.map(faultText)).toEqual([
      'mast.csv, line 3, speed: found the text "fast"; allowed: a number from 0 to 100, or nothing.',
    ]);
    const empty = await loadWind(file, async () => '');
    expect(empty.faults?.[0].path).toBe('mast.csv');
  });

  test('is not asked for where the file has none, or a fault', async () => {
    const never = async () => Promise.reject(new Error('asked'));
    expect((await loadWind(text, never)).wind).toEqual(FULL);
    expect((await loadWind('{', never)).faults).toHaveLength(1);
  });
});
