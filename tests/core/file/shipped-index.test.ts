import { describe, expect, test } from 'vitest';
import { faultText } from '../../../src/core/file/fault.ts';
import { parseIndex } from '../../../src/core/file/shipped-index.ts';

const entry = { id: 'light-air', name: 'Light air', file: 'light-air.json' };
const faultsOf = (value: unknown): string[] => (parseIndex(value).faults ?? []).map(faultText);

test('a good list is its entries, with a description or without', () => {
  const list = [entry, { ...entry, id: 'gale', description: 'Hard.', thumbnail: 'gale.svg', latin: 'Ventus' }];
  expect(parseIndex(list)).toEqual({ entries: list });
});

describe('one fault, at its place', () => {
  test.each([
    [{}, 'The file: found an object; allowed: a list of files.'],
    [[4], '[0]: found 4; allowed: an object.'],
    [
      [{ ...entry, id: 'Light Air' }],
      '[0].id: found the text "Light Air"; allowed: small letters and digits with hyphens between, as "light-air".',
    ],
    [[{ ...entry, name: ' ' }], '[0].name: found the text " "; allowed: a text.'],
    [
      [{ ...entry, file: '../secret.json' }],
      '[0].file: found the text "../secret.json"; allowed: the name of a file beside this one.',
    ],
    [[{ id: 'a', name: 'A' }], '[0].file: found nothing; allowed: the name of a file beside this one.'],
    [[{ ...entry, thumbnial: 'a.svg' }], '[0].thumbnial: found an unknown key; allowed: "thumbnail".'],
    [[{ ...entry, seed: 1.5 }], '[0].seed: found 1.5; allowed: a whole number from 0.'],
    [
      [{ ...entry, height: [3, 2] }],
      '[0].height: found the list [3, 2]; allowed: two numbers above 0, metres, the smaller first.',
    ],
    [
      [{ ...entry, seasons: ['monsoon'] }],
      '[0].seasons: found a list of 1; allowed: a list of spring, summer, autumn, winter.',
    ],
    [
      [{ ...entry, portrait: '../a.webp' }],
      '[0].portrait: found the text "../a.webp"; allowed: the name of a file beside this one.',
    ],
    [[entry, entry], '[1].id: found the text "light-air"; allowed: an id that no other has.'],
  ])('%j', (value, fault) => {
    expect(faultsOf(value)).toEqual([fault]);
  });
});
