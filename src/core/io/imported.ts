import type { Fault } from '../file/fault.ts';
import type { Species } from '../species/species.ts';

/** A species made of another program's file, and in sentences what could not be carried over; or what is wrong with the file. */
export type Imported =
  | {
      readonly species: Species;
      readonly notes: readonly string[];
      /** The seed that the file grows its tree from, where it has one; the numbers drawn from it are other ones here. */
      readonly seed?: number;
      readonly faults?: undefined;
    }
  | {
      readonly species?: undefined;
      readonly notes?: undefined;
      readonly seed?: undefined;
      readonly faults: readonly Fault[];
    };

/** A file of another program is a few kilobytes; this much is something else. */
export const LONGEST_IMPORT = 1_000_000;

/** Whether a text looks like a tree of Arbaro, so that `parseArbaro` is the one to read it or to say what is wrong with it. */
export const isArbaro = (text: string): boolean => /^[\ufeff\s]*</.test(text) && /<arbaro[\s/>]/.test(text);

/** Whether a text looks like a tree of ez-tree, so that `parseEzTree` is the one to read it or to say what is wrong with it. */
export function isEzTree(text: string): boolean {
  if (text.length > LONGEST_IMPORT || !/^[\ufeff\s]*\{/.test(text) || !/"branch"\s*:/.test(text)) return false;
  try {
    const value: unknown = JSON.parse(text.replace(/^\ufeff/, ''));
    return typeof value === 'object' && value !== null && 'branch' in value && !('format' in value);
  } catch {
    // Broken JSON is told by the reader of species: where it breaks is all that can be said of it.
    return false;
  }
}
