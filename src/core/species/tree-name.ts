import { LONGEST_NAME } from './parse.ts';

/** What cannot be seen or stands in no address: control characters, marks that turn the direction of writing, halves of letters. */
const UNSEEN = /[\p{Cc}\p{Cs}\u2028\u2029\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]/gu;

/** A name as a tree bears it: one line of at most 80 letters without spaces at its ends; null where nothing is left. */
export function treeNameOf(text: string): string | null {
  const line = text
    .slice(0, 4 * LONGEST_NAME)
    .replace(UNSEEN, ' ')
    .replace(/\s+/g, ' ')
    .trim();
  // Letters, not halves of them; a name of 80 of the longest is still one that a file may have.
  let name = '';
  for (const letter of line) {
    if (name.length + letter.length > LONGEST_NAME) break;
    name += letter;
  }
  return name.trim() || null;
}
