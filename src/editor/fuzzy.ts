/** Small letters and digits alone, words apart by one space. */
export const plain = (text: string): string =>
  text
    .toLowerCase()
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^\p{L}\p{N}?]+/gu, ' ')
    .trim();

/** What one word of a query is worth in a text: the beginning of a word more than its middle, letters in order least; 0: not there. */
function worth(word: string, text: string): number {
  if (` ${text}`.includes(` ${word}`)) return text.startsWith(word) ? 5 : 4;
  if (word.length > 1 && text.includes(word)) return 2;
  return inOrder(word, text) ? 1 : 0;
}

/** Whether the letters of a word stand in a text in their order, each run of them from the beginning of a word of the text. */
function inOrder(word: string, text: string): boolean {
  let at = -1;
  for (const letter of word) {
    const next = text[at + 1] === letter && at >= 0 ? at + 1 : ` ${text}`.indexOf(` ${letter}`, Math.max(0, at + 1));
    if (next < 0) return false;
    at = next;
  }
  return true;
}

/**
 * How well a query fits a text, both `plain`: each of its words must; 0 where one does not.
 *
 * Words may come in any order, and letters may be the beginnings of words: `dal` finds `down angle of limbs`.
 */
export function fits(query: string, text: string): number {
  let sum = 0;
  for (const word of query.split(' ')) {
    if (word === '') continue;
    const found = worth(word, text);
    if (found === 0) return 0;
    sum += found;
  }
  // Of two texts that fit alike, the shorter says little else.
  return sum + 1 / (1 + text.length);
}
