import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { isAllowed } from '../../../src/core/file/allowed.ts';
import { describeWindParameters } from '../../../src/core/wind/describe-wind.ts';
import { DEFAULT_GUST, DEFAULT_WAVE, STILL } from '../../../src/core/wind/wind.ts';
import { WIND_PARTS, type WindPart } from '../../../src/core/wind/wind-parameters.ts';
import { windJsonSchema } from '../../../src/core/wind/wind-schema.ts';
import { windsFolder } from './shipped-winds.ts';

const parts: readonly WindPart[] = Object.values(WIND_PARTS);
const rows = parts.flatMap((part) => part.parameters.map((p) => [`${part.group}.${p.key}`, part, p] as const));

describe('the parameter table of the wind', () => {
  test.each(rows)('%s is complete', (_, part, p) => {
    expect(p.group).toBe(part.group);
    expect(p.label).toMatch(/^\S/);
    expect(p.help).toMatch(/^[A-Z0-9].*\.$/);
    expect(p.optional).toBe(true);
    expect(isAllowed(p, p.default)).toBe(true);
    if (p.symbol) expect(p.section).toMatch(/^(Skjermo 2007, equations? \d+( and \d+)?|Weber & Penn 1995, 4\.\d|)$/);
  });

  test('has every setting of a wind and no other, at its default', () => {
    const defaultsOf = ({ parameters }: WindPart) => Object.fromEntries(parameters.map((p) => [p.key, p.default]));
    const { name, description, waves, gusts, profile, record, spring, sway, ...whole } = STILL;
    expect(defaultsOf(WIND_PARTS.whole)).toEqual(whole);
    expect(defaultsOf(WIND_PARTS.waves)).toEqual(DEFAULT_WAVE);
    expect(defaultsOf(WIND_PARTS.gusts)).toEqual(DEFAULT_GUST);
    expect(defaultsOf(WIND_PARTS.profile)).toEqual(profile);
    expect({ ...defaultsOf(WIND_PARTS.spring), levels: [] }).toEqual(spring);
    expect(defaultsOf(WIND_PARTS.springLevels)).toEqual({ frequency: null, damping: null });
    expect(defaultsOf(WIND_PARTS.sway)).toEqual(sway);
  });
});

describe('files made from the table are current (npx vitest run tests/core/wind/wind-table.test.ts -u writes them anew)', () => {
  test('wind.schema.json', async () => {
    await expect(`${JSON.stringify(windJsonSchema(), null, 1)}\n`).toMatchFileSnapshot(
      join(windsFolder, 'wind.schema.json'),
    );
  });
  test('docs/wind-parameters.md', async () => {
    const page = join(import.meta.dirname, '../../../docs/wind-parameters.md');
    await expect(describeWindParameters()).toMatchFileSnapshot(page);
  });
});

test('the JSON Schema has the limits of the table', () => {
  expect(windJsonSchema()).toMatchObject({
    required: ['format', 'version', 'name'],
    additionalProperties: false,
    properties: {
      model: { enum: ['direct', 'spring', 'sway'], default: 'spring' },
      waves: { maxItems: 8, items: { additionalProperties: false, properties: { wavelength: { minimum: 0.1 } } } },
      gusts: { maxItems: 16 },
      spring: {
        properties: { levels: { maxItems: 4, items: { properties: { frequency: { type: ['number', 'null'] } } } } },
      },
      record: { default: null },
    },
  });
});
