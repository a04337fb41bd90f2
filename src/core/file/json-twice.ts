import { oneLine } from './one-line.ts';

/** What matters in a text that is JSON: strings and punctuation; numbers and words between them are passed over. */
const TOKEN = /"(?:[^"\\]|\\.)*"|[{}[\],:]/g;

/** An object or a list that is open, and what is being read of it. */
interface Open {
  /** Keys so far; null in a list. */
  readonly keys: Set<string> | null;
  key: string;
  index: number;
}

const pathOf = (open: readonly Open[], key: string): string =>
  [...open.slice(0, -1).map(({ keys, key, index }) => (keys ? `.${oneLine(key)}` : `[${index}]`)), `.${oneLine(key)}`]
    .join('')
    .replace(/^\./, '');

/**
 * The path of the first key that stands twice in an object, or undefined: JSON.parse takes the last of them without a word.
 *
 * `text` must be JSON.
 */
export function jsonTwice(text: string): string | undefined {
  const open: Open[] = [];
  /** The last string, which is a key where a colon follows. */
  let last = '';
  for (const [token] of text.matchAll(TOKEN)) {
    const top = open.at(-1);
    if (token === '{') open.push({ keys: new Set(), key: '', index: 0 });
    else if (token === '[') open.push({ keys: null, key: '', index: 0 });
    else if (token === '}' || token === ']') open.pop();
    else if (token === ',') {
      if (top) top.index++;
    } else if (token === ':' && top?.keys) {
      const key = JSON.parse(last) as string;
      if (top.keys.has(key)) return pathOf(open, key);
      top.keys.add(key);
      top.key = key;
    } else last = token;
  }
  return undefined;
}
