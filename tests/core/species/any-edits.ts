import fc from 'fast-check';
import { mayBe, type ParameterValue, PLACES, type SpeciesEdits } from '../../../src/core/species/edits.ts';

/** Never -0: what is read of it is 0. */
const number = (min: number, max: number) => fc.double({ min, max, noNaN: true }).map((x) => x + 0);

/** Any value that a parameter may have. */
export const anyValue = (path: string): fc.Arbitrary<ParameterValue> => {
  const { parameter: p } = PLACES.get(path)!;
  const none = mayBe(path, null) ? [fc.constant(null)] : [];
  switch (p.kind) {
    case 'number':
      return fc.oneof(p.integer ? fc.integer({ min: p.min, max: p.max }) : number(p.min, p.max), ...none);
    case 'numbers':
      return fc.oneof(fc.array(number(p.min, p.max), { minLength: p.least ?? 1, maxLength: 8 }), ...none);
    case 'flag':
      return fc.boolean();
    case 'choice':
      return fc.constantFrom(...p.choices);
    case 'colour':
      return fc.integer({ min: 0, max: 0xffffff }).map((x) => `#${x.toString(16).padStart(6, '0').toUpperCase()}`);
  }
};
/** Any edits of a few parameters. */
export const anyEdits: fc.Arbitrary<SpeciesEdits> = fc
  .uniqueArray(fc.constantFrom(...PLACES.keys()), { maxLength: 12 })
  .chain((paths) => fc.tuple(...paths.map((path) => fc.tuple(fc.constant(path), anyValue(path)))))
  .map((pairs) => Object.fromEntries(pairs));
