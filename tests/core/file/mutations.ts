import fc from 'fast-check';

/** What a value of a file is replaced by, as it stands in the text: much of it is no JSON. */
const EVIL = [
  ...[
    'null',
    'true',
    'false',
    '0',
    '-0',
    '1',
    '-1',
    '2.5',
    '1e300',
    '-1e300',
    '1e999',
    '-1e999',
    '1e-400',
    '5e-324',
    '9007199254740993',
  ],
  ...['NaN', 'Infinity', 'undefined', '0x10', '01', '.5', '', ',', '}', ']', '"'],
  ...[
    '""',
    '"13"',
    '"NaN"',
    '"__proto__"',
    '"\\ud800"',
    '"\\u202e<b>x</b>\\u0000"',
    `"${'a'.repeat(5000)}"`,
    '"#12345g"',
  ],
  ...[
    '[]',
    '{}',
    '[[]]',
    '[null]',
    '[1,2,3,4,5,6,7,8,9]',
    '{"__proto__":{"scale":1}}',
    '{"toString":1}',
    '{"length":1e9}',
  ],
  '['.repeat(3000),
  `${'['.repeat(2000)}${']'.repeat(2000)}`,
  `${'{"a":'.repeat(500)}1${'}'.repeat(500)}`,
];

const KEYS = [
  '__proto__',
  'constructor',
  'toString',
  'hasOwnProperty',
  '',
  'a\nb',
  '\ud800',
  'x'.repeat(3000),
  '0',
  'length',
];

/** One thing that is done to a text. */
type Mutation =
  | { readonly kind: 'value' | 'delete' | 'rename' | 'twice' | 'add'; readonly at: number; readonly pick: number }
  | { readonly kind: 'splice'; readonly at: number; readonly pick: number; readonly text: string }
  | { readonly kind: 'cut' | 'double'; readonly at: number; readonly pick: number };

const pick = fc.nat(1_000_000);
const anyMutation: fc.Arbitrary<Mutation> = fc.oneof(
  { weight: 8, arbitrary: fc.record({ kind: fc.constant('value' as const), at: pick, pick }) },
  {
    weight: 5,
    arbitrary: fc.record({
      kind: fc.constantFrom('delete' as const, 'rename' as const, 'twice' as const, 'add' as const),
      at: pick,
      pick,
    }),
  },
  {
    weight: 3,
    arbitrary: fc.record({
      kind: fc.constant('splice' as const),
      at: pick,
      pick,
      text: fc.string({ unit: 'binary', maxLength: 6 }),
    }),
  },
  { weight: 1, arbitrary: fc.record({ kind: fc.constantFrom('cut' as const, 'double' as const), at: pick, pick }) },
);

/** A key with its value, as they stand in a JSON text: `"scale": 13`. */
const PAIR = /("(?:[^"\\]|\\.)*")(\s*:\s*)("(?:[^"\\]|\\.)*"|-?[\d.eE+-]+|true|false|null|\[[^[\]{}]*\])/g;

function mutated(text: string, m: Mutation): string {
  const place = text.length === 0 ? 0 : m.at % text.length;
  if (m.kind === 'splice') return text.slice(0, place) + m.text + text.slice(place + (m.pick % 4));
  if (m.kind === 'cut') return text.slice(0, place);
  if (m.kind === 'double') return text.slice(0, place) + text.slice(Math.max(0, place - (m.pick % 400)));
  const pairs = [...text.matchAll(PAIR)];
  const found = pairs[m.at % Math.max(1, pairs.length)];
  if (!found) return text;
  const [whole, key, colon, value] = found as unknown as [string, string, string, string];
  const evil = EVIL[m.pick % EVIL.length]!;
  const name = JSON.stringify(KEYS[m.pick % KEYS.length]);
  const put = {
    value: `${key}${colon}${evil}`,
    delete: '',
    rename: `${name}${colon}${value}`,
    twice: `${whole}, ${whole}`,
    add: `${whole}, ${name}: ${evil}`,
  }[m.kind];
  let [before, after] = [text.slice(0, found.index), text.slice(found.index + whole.length)];
  // A pair goes with its comma, so that the rest is still JSON.
  if (m.kind === 'delete') {
    if (/^\s*,/.test(after)) after = after.replace(/^\s*,/, '');
    else before = before.replace(/,\s*$/, '');
  }
  return before + put + after;
}

/** Texts of good files with one to four things done to them; half of them are still JSON. */
export const mutatedTexts = (good: readonly string[]): fc.Arbitrary<string> =>
  fc
    .tuple(fc.constantFrom(...good), fc.array(anyMutation, { minLength: 1, maxLength: 4 }))
    .map(([text, mutations]) => mutations.reduce(mutated, text));

/** Paths of all numbers in a value that are not finite, and of keys that no plain object has. */
export function unsound(value: unknown, path = '$'): string[] {
  if (typeof value === 'number') return Number.isFinite(value) ? [] : [path];
  if (typeof value !== 'object' || value === null) return [];
  const odd =
    Array.isArray(value) || Object.getPrototypeOf(value) === Object.prototype ? [] : [`${path} has a prototype`];
  return [...odd, ...Object.entries(value).flatMap(([key, v]) => unsound(v, `${path}.${key}`))];
}
