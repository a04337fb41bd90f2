import { readFileSync } from 'node:fs';
import { cli } from '@custom-elements-manifest/analyzer/cli.js';
import { describe, expect, test } from 'vitest';
import { ATTRIBUTES } from '../../src/element/attributes.ts';

interface Entry {
  readonly name: string;
  readonly description?: string;
  readonly kind?: string;
  readonly fieldName?: string;
}
interface Manifest {
  readonly modules: readonly { readonly declarations: readonly Record<string, readonly Entry[]>[] }[];
}

const read = (path: string): string => readFileSync(path, 'utf8');
const written = JSON.parse(read('custom-elements.json')) as Manifest;
const element = written.modules.flatMap(({ declarations }) => declarations)[0]!;
const names = (key: string): string[] => element[key]!.map(({ name }) => name).sort();
const found = (text: string, pattern: RegExp): string[] =>
  [...new Set([...text.matchAll(pattern)].map(([, name]) => name!))].sort();

describe('custom-elements.json', () => {
  test('is what `npm run manifest` makes of the code', async () => {
    const made = await cli({
      argv: ['analyze', '--quiet', '--config', 'src/element/manifest.config.mjs'],
      cwd: process.cwd(),
      noWrite: true,
    });
    expect(JSON.parse(JSON.stringify(made))).toEqual(written);
  });

  test('has every attribute of the table, under the property that reads it', () => {
    expect(names('attributes')).toEqual([...Object.keys(ATTRIBUTES), 'alt', 'camera-controls', 'paused'].sort());
    for (const { name, fieldName } of element.attributes!) {
      const row = ATTRIBUTES[name as keyof typeof ATTRIBUTES];
      if (row) expect(fieldName, name).toBe(row.property);
    }
  });

  test('has the events, slots, parts, properties and states that the code has', () => {
    const shadow = read('src/element/element-shadow.ts');
    const styles = read('src/element/element-styles.ts');
    const events = read('src/element/element-events.ts').split('interface WindTreeEventDetails {')[1]!.split('\n}')[0]!;
    expect(names('events')).toEqual(found(events, /^ {2}'?([\w-]+)'?:/gm));
    expect(names('slots')).toEqual(['', ...found(shadow, /\bslot\('([\w-]+)'/g)]);
    expect(names('cssParts')).toEqual(found(shadow, /part: '([\w-]+)'/g));
    expect(names('cssProperties')).toEqual(found(styles, /var\((--[\w-]+)/g));
    expect(names('cssStates')).toEqual(['error', 'loading', 'paused', 'ready']);
  });

  test('says what each of it is for', () => {
    for (const key of ['attributes', 'events', 'slots', 'cssParts', 'cssProperties', 'cssStates', 'members'])
      for (const { name, description } of element[key]!) expect(description, `${key} ${name}`).toMatch(/\S{2}.*\.$/s);
  });

  test('has the methods that the documentation tells of', () => {
    const methods = element.members!.filter(({ kind }) => kind === 'method').map(({ name }) => name);
    expect(methods.sort()).toEqual(
      [
        'dismissPoster',
        'exportGLB',
        'getState',
        'pause',
        'play',
        'seek',
        'setState',
        'showPoster',
        'step',
        'toBlob',
      ].sort(),
    );
    const documented = read('docs/element.md');
    for (const name of [...methods, ...names('attributes'), ...names('events'), ...names('cssProperties')])
      expect(documented, name).toContain(`\`${name}`);
  });
});
