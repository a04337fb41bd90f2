import { jsonFault } from './json-fault.ts';
import { jsonTwice } from './json-twice.ts';

/** One thing that is wrong with a file. All three are plain text, never markup. */
export interface Fault {
  /** Where in the file: 'levels[2].curveRes'; '' for the file as a whole. */
  readonly path: string;
  /** What stands there. */
  readonly found: string;
  /** What may stand there. */
  readonly allowed: string;
}

/** A fault on one line. */
export const faultText = ({ path, found, allowed }: Fault): string =>
  `${path === '' ? 'The file' : path}: found ${found}; allowed: ${allowed}.`;

/** What stands in the text of a file, or why it cannot be read. */
export type ReadJson =
  | { readonly value: unknown; readonly fault?: undefined }
  | { readonly value?: undefined; readonly fault: Fault };

/**
 * What JSON.parse makes of the text of a file, or the fault that it has as a whole; never throws. A key that stands twice is a
 * fault: nobody can see which of the two holds.
 *
 * `kind` is what the file should be, in words: 'a species'. A text longer than `longest` characters is not read: it is something else.
 */
export function readJson(text: string, kind: string, longest: number): ReadJson {
  // Some editors begin a file with a byte order mark; a browser takes it off as it reads, Node does not.
  const input = text.replace(/^\ufeff/, '');
  const broken = (found: string): ReadJson => ({ fault: { path: '', found, allowed: `${kind} as a JSON document` } });
  if (input.trim() === '') return broken('an empty file');
  if (input.length > longest) return broken(`${input.length} characters`);
  let value: unknown;
  try {
    value = JSON.parse(input);
  } catch {
    return broken(`broken JSON ${placeOf(jsonFault(input), input)}`);
  }
  const twice = jsonTwice(input);
  return twice === undefined
    ? { value }
    : { fault: { path: twice, found: 'the key twice', allowed: 'one of the two' } };
}

function placeOf(index: number, text: string): string {
  const before = text.slice(0, index).split('\n');
  const place = `at line ${before.length}, column ${before[before.length - 1].length + 1}`;
  return index === text.length ? `that ends too early, ${place}` : place;
}
