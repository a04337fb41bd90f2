import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { isAllowed } from '../../../src/core/file/allowed.ts';
import { describeParameters } from '../../../src/core/species/describe.ts';
import { defaultOf, GROUPS, PARAMETERS } from '../../../src/core/species/parameters.ts';
import { speciesJsonSchema } from '../../../src/core/species/schema.ts';
import { BARK_KINDS } from '../../../src/core/species/species.ts';
import { folder, names, shipped } from '../grow/species.ts';

describe('the parameter table', () => {
  test.each(PARAMETERS.map((p) => [`${p.group}.${p.key}`, p] as const))('%s is complete', (_, p) => {
    expect(p.label).toMatch(/^\S/);
    expect(p.help).toMatch(/^[A-Z0-9].*\.$/);
    // A parameter of the paper says where it is explained; others may be left out.
    if (p.symbol) expect(p.section).toMatch(/^(4\.\d|appendix)$/);
    else expect(p.optional).toBe(true);
    for (const level of [0, 1]) {
      const value = defaultOf(p, level);
      if (value === undefined) expect(p.optional).toBe(true);
      else expect(isAllowed(p, value)).toBe(true);
    }
    if (p.kind === 'number') {
      expect(p.max).toBeGreaterThan(p.min);
      expect(p.step).toBeGreaterThan(0);
      // A range that reaches below zero says what that means, except for plain angles.
      if (p.min < 0 && p.unit !== 'deg') expect(p.negative).toMatch(/^Below 0 /);
      if (p.names) expect(p.names).toHaveLength(p.max + 1);
    }
  });

  test('has every key once', () => {
    for (const { parameters } of GROUPS) expect(new Set(parameters.map((p) => p.key)).size).toBe(parameters.length);
  });

  test('has every parameter of a species and no other', () => {
    for (const name of names) {
      const species = shipped(name);
      for (const { group, parameters } of GROUPS) {
        const keys = parameters.filter((p) => defaultOf(p) !== undefined).map((p) => p.key);
        const all = parameters.map((p) => p.key);
        for (const part of group === 'levels' ? species.levels : [species[group]]) {
          expect(Object.keys(part)).toEqual(expect.arrayContaining(keys));
          expect(all).toEqual(expect.arrayContaining(Object.keys(part)));
        }
      }
    }
  });
});

describe('files made from the table are current (npx vitest run tests/core/species -u writes them anew)', () => {
  test('species.schema.json', async () => {
    await expect(`${JSON.stringify(speciesJsonSchema(), null, 1)}\n`).toMatchFileSnapshot(
      join(folder, 'species.schema.json'),
    );
  });
  test('docs/parameters.md', async () => {
    await expect(describeParameters()).toMatchFileSnapshot(join(import.meta.dirname, '../../../docs/parameters.md'));
  });
});

describe('the JSON Schema', () => {
  type Schema = {
    properties: Record<string, Schema>;
    required: string[];
    prefixItems: Schema[];
    items: Schema;
  } & Record<string, unknown>;
  const schema = speciesJsonSchema() as unknown as Schema;

  test('requires what the parser requires', () => {
    expect(schema.required).toEqual(['format', 'version', 'name', 'tree', 'levels', 'leaves', 'pruning']);
    expect(schema.properties.levels.prefixItems[0].required).toContain('baseSplits');
    expect(schema.properties.levels.prefixItems[0].required).not.toContain('downAngle');
    expect(schema.properties.levels.items.required).toContain('downAngle');
    expect(schema.properties.levels.items.required).not.toContain('baseSplits');
  });

  test('has the limits of the table', () => {
    expect(schema.properties.tree.properties.levels).toMatchObject({ type: 'integer', minimum: 1, maximum: 8 });
    expect(schema.properties.bark.properties.kind).toMatchObject({ enum: [...BARK_KINDS] });
    expect(schema.properties.tree.additionalProperties).toBe(false);
  });
});
