import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { windThumbnail } from '../../../docs/wind-thumbnail.ts';
import { parseIndex } from '../../../src/core/file/shipped-index.ts';
import { beaufortOf, speedOfForce } from '../../../src/core/wind/speed.ts';
import { STILL, type Wind } from '../../../src/core/wind/wind.ts';
import { windText } from '../../../src/core/wind/wind-file.ts';
import { parseWindWithRecord } from '../../../src/core/wind/wind-with-record.ts';
import { felt } from './force-over-time.ts';
import { shippedWind, windNames, windsFolder, windsText } from './shipped-winds.ts';

const entries = parseIndex(JSON.parse(windsText('index.json'))).entries!;
const ids = entries.map(({ id }) => id);

/** From weak to strong: the names of the Beaufort scale. */
const SCALE = [
  'still',
  'light-air',
  'light-breeze',
  'breeze',
  'fresh-breeze',
  'strong-breeze',
  'near-gale',
  'gale',
  'strong-gale',
  'storm',
];

describe('the list of winds', () => {
  test('has every file once, at least twelve, from still to storm first', () => {
    expect(ids.length).toBeGreaterThanOrEqual(12);
    expect(ids.slice(0, SCALE.length)).toEqual(SCALE);
    expect([...ids].sort()).toEqual([...windNames].sort());
    const files = entries.flatMap(({ file, thumbnail }) => [file, thumbnail]);
    const own = ['index.json', 'wind.schema.json', 'kaimal-sample.csv'];
    expect([...files, ...own].sort()).toEqual(readdirSync(windsFolder).sort());
  });

  test.each(entries.map((entry) => [entry.id, entry] as const))('%s says what its file says', (id, entry) => {
    const { name, description } = shippedWind(id);
    const files = { file: `${id}.json`, thumbnail: `${id}.svg` };
    expect(entry).toEqual({ id, name, description, ...files });
    expect(description).toMatch(/^[A-Z].{20,}\.$/);
  });
});

describe.each(ids)('%s', (id) => {
  const wind = shippedWind(id);

  test('writes everything out, as its file has it', () => {
    const { recordFile } = parseWindWithRecord(windsText(`${id}.json`), windsText);
    expect(windText(wind, recordFile)).toBe(windsText(`${id}.json`));
    if (recordFile) expect(existsSync(join(windsFolder, recordFile))).toBe(true);
  });

  test('has a thumbnail of its own field (npx tsx docs/make-wind-thumbnails.ts draws it anew)', () => {
    expect(windsText(`${id}.svg`)).toBe(windThumbnail(wind));
    expect(windsText(`${id}.svg`).length).toBeLessThan(6000);
    expect(windsText(`${id}.svg`)).toContain('currentColor');
  });

  test('bends by springs, but for the two of the papers', () => {
    const papers: Record<string, Partial<Wind>> = {
      'paper-2007': { model: 'direct', pose: 'lagged' },
      'sway-1995': { model: 'sway', pose: 'exact' },
    };
    expect(wind).toMatchObject(papers[id] ?? { model: STILL.model, pose: 'exact' });
  });
});

/** Winds that are named after the Beaufort scale, and their numbers there. */
const BEAUFORT_NAMED: Record<string, number> = {
  still: 0,
  'light-air': 1,
  'light-breeze': 2,
  breeze: 3,
  'fresh-breeze': 5,
  'strong-breeze': 6,
  'near-gale': 7,
  gale: 8,
  'strong-gale': 9,
  storm: 10,
};

test.each(Object.entries(BEAUFORT_NAMED))('%s has the mean force of Beaufort %d, and gusts on top', (id, number) => {
  const { mean, deviation, peak } = felt(shippedWind(id), 600);
  const size = Math.hypot(...mean);
  expect(beaufortOf(speedOfForce(size)).number).toBe(number);
  if (number === 0) return;
  expect(deviation).toBeGreaterThan(0.2 * size);
  expect(peak).toBeGreaterThan(1.4 * size);
  expect(peak).toBeLessThan(3 * size);
});

test('those that begin as a breeze have its waves', () => {
  for (const id of ['still', 'sway-1995']) expect(shippedWind(id).waves).toEqual(shippedWind('breeze').waves);
  expect(shippedWind('still').strength).toBe(0);
});

/** What makes one wind feel unlike another, each as a number that is apart by one where the difference is plain. */
function feel(id: string): Record<string, number> {
  const wind = shippedWind(id);
  const { mean, deviation, peak } = felt(wind, 180);
  const low = felt(wind, 60, [0, 0, 2]);
  const size = Math.hypot(...mean);
  return {
    strength: Math.log(peak + 0.005) / Math.log(1.25),
    unrest: Math.min(3, deviation / (size + 0.005)) / 0.3,
    bursts: Math.min(12, peak / (size + 0.005)) / 2,
    direction: (size > 0.01 ? Math.atan2(mean[1], mean[0]) : 0) / 0.6,
    shelter: low.peak / (felt(wind, 60).peak + 0.005) / 0.3,
    model: { direct: 0, spring: 10, sway: 20 }[wind.model],
  };
}

test('no two of them feel alike', () => {
  const feels = ids.map((id) => [id, feel(id)] as const);
  for (const [a, one] of feels)
    for (const [b, other] of feels) {
      if (a === b) continue;
      const apart = Math.hypot(...Object.keys(one).map((key) => one[key] - other[key]));
      expect(apart, `${a} and ${b}`).toBeGreaterThan(0.85);
    }
});

test('from still to storm peaks and means grow', () => {
  const felts = SCALE.map((id) => felt(shippedWind(id), 240));
  for (let i = 1; i < felts.length; i++) {
    expect(felts[i].peak).toBeGreaterThan(1.15 * felts[i - 1].peak);
    expect(Math.hypot(...felts[i].mean)).toBeGreaterThan(1.15 * Math.hypot(...felts[i - 1].mean));
  }
  expect(felts[0].peak).toBe(0);
});

/** The wind as it is `time` seconds later, by its gusts. */
const later = (wind: Wind, time: number): Wind => ({
  ...wind,
  gusts: wind.gusts.map((gust) => ({ ...gust, start: gust.start - time })),
});

describe('characters', () => {
  test('the trade wind hardly changes, the gusty afternoon does, the courtyard has no mean', () => {
    const unrest = (id: string): number => {
      const { mean, deviation } = felt(shippedWind(id), 180);
      return deviation / Math.hypot(...mean);
    };
    expect(unrest('trade-wind')).toBeLessThan(0.12);
    expect(unrest('gusty-afternoon')).toBeGreaterThan(1);
    const { mean, peak } = felt(shippedWind('courtyard'), 600);
    expect(Math.hypot(...mean)).toBeLessThan(0.02 * peak);
  });

  test('the squall comes out of a calm within two seconds and dies away', () => {
    const squall = shippedWind('thunder-squall');
    expect(felt(squall, 5).peak).toBeLessThan(0.05);
    expect(felt(squall, 9).peak).toBeGreaterThan(0.5);
    const at = (time: number): number => felt(later(squall, time), 1).peak;
    expect(at(60)).toBeLessThan(0.05);
  });

  test('the squall and the gusts of the afternoon come again for ever', () => {
    const squall = shippedWind('thunder-squall');
    const afternoon = shippedWind('gusty-afternoon');
    for (const time of [0, 1400, 140e4]) {
      expect(felt(later(squall, time), 20).peak).toBeGreaterThan(1.2);
      expect(felt(later(afternoon, time), 90).peak).toBeGreaterThan(0.35);
    }
  });

  test('the sea breeze and the tree tops have less wind below than above', () => {
    for (const [id, part] of [
      ['sea-breeze', 0.8],
      ['tree-tops', 0.3],
    ] as const) {
      const wind = shippedWind(id);
      expect(felt(wind, 60, [0, 0, 2]).peak).toBeLessThan(part * felt(wind, 60, [0, 0, 10]).peak);
    }
  });

  test('the paper of 2007 has its four waves and its exponents', () => {
    const wind = shippedWind('paper-2007');
    expect(wind.waves).toHaveLength(4);
    expect([wind.gusts, wind.record, wind.profile.kind, wind.zeroMean]).toEqual([[], null, 'none', false]);
    expect([wind.forceExponent, wind.lengthExponent]).toEqual([1.8, 2]);
  });
});
