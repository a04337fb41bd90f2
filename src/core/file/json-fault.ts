const SPACE = /[ \t\n\r]*/y;
const TOKEN =
  /[{}[\],:]|"(?:[^"\\\p{Cc}]|[\u007f-\u009f]|\\(?:["\\/bfnrt]|u[\da-fA-F]{4}))*"|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null/uy;

/** What may come next: a value, the first item or `]`, the first key or `}`, a key, a colon, or `,` and the closing bracket. */
type Next = 'value' | 'item' | 'firstKey' | 'key' | 'colon' | 'after';

/** What comes after a token, or undefined where the token may not stand here; `open` is the stack of brackets. */
function step(next: Next, token: string, open: string[]): Next | undefined {
  const close = next === 'item' ? ']' : next === 'firstKey' ? '}' : open[open.length - 1];
  if (token === close && (next === 'item' || next === 'firstKey' || next === 'after')) {
    open.pop();
    return 'after';
  }
  if (next === 'colon') return token === ':' ? 'value' : undefined;
  if (next === 'after') return token === ',' && close ? (close === '}' ? 'key' : 'value') : undefined;
  if (next === 'key' || next === 'firstKey') return token.startsWith('"') ? 'colon' : undefined;
  if (token === '{' || token === '[') {
    open.push(token === '{' ? '}' : ']');
    return token === '{' ? 'firstKey' : 'item';
  }
  return /^[}\],:]$/.test(token) ? undefined : 'after';
}

/**
 * Where a text stops being JSON, as the index of the first character that cannot stand there; its length where it only ends too early.
 *
 * JSON.parse knows, but engines do not tell alike.
 */
export function jsonFault(text: string): number {
  const open: string[] = [];
  let next: Next = 'value';
  let at = 0;
  for (;;) {
    SPACE.lastIndex = at;
    at += SPACE.exec(text)?.[0].length ?? 0;
    TOKEN.lastIndex = at;
    const token = TOKEN.exec(text)?.[0];
    const after: Next | undefined = token === undefined ? undefined : step(next, token, open);
    if (token === undefined || after === undefined) return at;
    next = after;
    at += token.length;
  }
}
