import fc from 'fast-check';
import { expect, it } from 'vitest';
import { decodeLink, encodeLink, roundDocument } from '../../../src/core/link/link.ts';
import { packLink } from '../../../src/core/link/packed-link.ts';
import { mayBe } from '../../../src/core/species/edits.ts';
import { STILL } from '../../../src/core/wind/wind.ts';
import { firstDocument } from '../../../src/editor/first-document.ts';
import { unsound } from '../file/mutations.ts';
import { anyEdits } from '../species/any-edits.ts';

const defaults = firstDocument('auto', false, { ...STILL, name: 'Breeze' });
const options = { defaults, species: ['quaking-aspen', 'black-tupelo'], winds: { breeze: defaults.wind } };

const EVIL = [
  ...[
    '',
    ' ',
    '0',
    '-0',
    '-1',
    '1e9',
    '1e999',
    'NaN',
    'Infinity',
    'none',
    'null',
    'true',
    '__proto__',
    '%',
    '%00',
    '%F0%9F',
  ],
  ...['&', '=', '#', '&&&=', ',', ',,,,,,,,,,', '<b>', '\u202e', '\ud800', '99999999999999999999', '0x10', '.5', '5.'],
  ...['9'.repeat(400), 'a'.repeat(5000), '1,'.repeat(3000)],
];
const KEYS = [
  '__proto__',
  'levels.9.curve',
  'levels..curve',
  'tree',
  'tree.',
  'z',
  'own',
  'file',
  'b.b.w1',
  'w1',
  'cam',
];

/** A link that says much: edits, a name, a packed one now and then. */
const anyLink = fc
  .tuple(anyEdits, fc.constantFrom('', 'compare=split,0.4&', 'cam=1,2,3,4,5,6&levels=2&'), fc.boolean())
  .map(([edits, more, packed]) => {
    const link = `${more}${encodeLink({ ...defaults, edits, treeName: 'Old oak' })}`;
    return packed ? `z=${packLink(link)}` : link;
  });

const anyChange = fc.tuple(
  fc.constantFrom('value', 'key', 'splice', 'twice', 'cut'),
  fc.nat(100_000),
  fc.oneof(fc.constantFrom(...EVIL), fc.string({ unit: 'binary', maxLength: 8 })),
);

function changed(link: string, [kind, at, evil]: readonly [string, number, string]): string {
  const pairs = link.split('&');
  const i = at % pairs.length;
  const place = at % (link.length + 1);
  if (kind === 'cut') return link.slice(0, place);
  if (kind === 'splice') return link.slice(0, place) + evil + link.slice(place + (at % 3));
  const [key = '', value = ''] = pairs[i]!.split('=');
  if (kind === 'twice') pairs.push(pairs[i]!);
  else pairs[i] = kind === 'value' ? `${key}=${evil}` : `${KEYS[at % KEYS.length]}=${value}`;
  return pairs.join('&');
}

it('4000 mutated links give a document that can be shown and sent on, and a fault for each value that is wrong', () => {
  let faulty = 0;
  fc.assert(
    fc.property(anyLink, fc.array(anyChange, { minLength: 1, maxLength: 3 }), (good, changes) => {
      const { document, faults } = decodeLink(changes.reduce(changed, good), options);
      faulty += Math.min(faults.length, 1);
      expect(unsound(document)).toEqual([]);
      for (const [path, value] of Object.entries(document.edits)) expect(mayBe(path, value), path).toBe(true);
      expect(roundDocument(document)).toEqual(document);
      expect(decodeLink(encodeLink(document), options).document).toEqual(document);
      const keys = faults.map((f) => f.key);
      expect(new Set(keys).size).toBe(keys.length);
      for (const { allowed } of faults) expect(allowed).toMatch(/^\S/);
    }),
    { numRuns: 4000 },
  );
  expect(faulty).toBeGreaterThan(1000);
});
