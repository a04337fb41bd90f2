/** A word, a number, a sign of two letters, or any other sign. */
const TOKEN = /[A-Za-z_]\w*|0[xX][\da-fA-F]+[uU]?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUfF]?|\+\+|--|[^\s\w]/g;
const WORD = /^[A-Za-z_]\w*$/;

/** Types of GLSL; those of ours begin with a capital. */
const TYPE = /^(?:float|u?int|bool|[biu]?vec[234]|mat[234](?:x[234])?|[A-Z][a-z]\w*)$/;

/** `1.0` as `1.`, `0.5` as `.5`, which GLSL reads as the same. */
const shortNumber = (text: string): string =>
  /^\d*\.\d*$/.test(text) ? text.replace(/^(\d+\.\d*?)0+$/, '$1').replace(/^0+(?=\.\d)/, '') : text;

/** a, b, ... z, A, ... Z, aa, ... */
function shortName(n: number): string {
  const letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ';
  const rest = Math.floor(n / letters.length);
  return (rest > 0 ? shortName(rest - 1) : '') + letters[n % letters.length];
}

const RESERVED = new Set(['do', 'if', 'in']);

/** Names that a function declares: its arguments and what stands behind a type in it; those in capitals may be switches of the preprocessor. */
function declared(tokens: readonly string[]): Set<string> {
  const names = new Set<string>();
  tokens.forEach((token, i) => {
    const name = tokens[i + 1] ?? '';
    const after = tokens[i + 2] ?? '';
    if (TYPE.test(token) && WORD.test(name) && !TYPE.test(name) && after !== '(' && tokens[i - 1] !== '.')
      names.add(name);
  });
  return names;
}

/** A function with short names for what is its own. What others know, as its name, uniforms, members and functions that it calls, stays. */
function shortened(tokens: readonly string[]): string[] {
  // Text that is put there later may use them.
  if (tokens.some((token) => /^#\s*(?:pragma|include|define)/.test(token))) return [...tokens];
  const inSwitches = new Set(
    tokens.filter((token) => token.startsWith('#')).flatMap((line) => line.match(/\w+/g) ?? []),
  );
  const taken = new Set([...tokens, ...inSwitches]);
  const names = new Map<string, string>();
  let next = 0;
  for (const name of declared(tokens)) {
    if (name.length === 1 || inSwitches.has(name)) continue;
    let short = shortName(next++);
    while (taken.has(short) || RESERVED.has(short)) short = shortName(next++);
    if (short.length < name.length) names.set(name, short);
  }
  return tokens.map((token, i) => (tokens[i - 1] === '.' ? token : (names.get(token) ?? token)));
}

/** Words of a text without comments, a line of the preprocessor as one of them. */
const tokensOf = (text: string): string[] =>
  text.split('\n').flatMap((line) => {
    const trimmed = line.trim();
    return trimmed.startsWith('#') ? [trimmed.replace(/\s+/g, ' ')] : (trimmed.match(TOKEN) ?? []).map(shortNumber);
  });

/** From which token to which the functions of a file reach, their heads included. */
function functionsOf(tokens: readonly string[]): [number, number][] {
  const found: [number, number][] = [];
  let depth = 0;
  let start = 0;
  let head = false;
  tokens.forEach((token, i) => {
    if (depth === 0 && (token === ';' || token.startsWith('#'))) start = i + 1;
    if (token === '{') {
      if (depth === 0) head = tokens[i - 1] === ')';
      depth++;
    } else if (token === '}') {
      depth--;
      if (depth < 0) throw new Error('A shader closes a bracket that it has not opened.');
      if (depth === 0) {
        if (head) found.push([start, i + 1]);
        start = i + 1;
      }
    }
  });
  // As where two heads of one function stand under different switches: names could not be told apart.
  if (depth !== 0) throw new Error('A shader leaves a bracket open.');
  return found;
}

/** Whether two words would be read as one, or two signs as a third, if nothing stood between them. */
const parts = (last: string, next: string): boolean =>
  !last.startsWith('#') &&
  ((/[\w.]$/.test(last) && /^\w/.test(next) && last !== '.') || (/[+-]$/.test(last) && last.at(-1) === next[0]));

/** Tokens as one text: lines of the preprocessor on their own, a space only where two words would become one, or two signs a third. */
function joined(tokens: readonly string[]): string {
  let out = '';
  let last = '';
  for (const token of tokens) {
    if (token.startsWith('#')) out += `${out === '' || out.endsWith('\n') ? '' : '\n'}${token}\n`;
    else out += (parts(last, token) ? ' ' : '') + token;
    last = token;
  }
  return out;
}

/**
 * A shader, without comments, in fewer letters: no space that is not needed, short names for what a function declares.
 *
 * A name that its text is patched by, or that a program knows, is none of these: uniforms, attributes, members and functions keep theirs.
 */
export function minifiedGlsl(text: string): string {
  const tokens = tokensOf(text);
  const functions = functionsOf(tokens);
  let done = 0;
  const out: string[] = [];
  for (const [from, to] of functions) {
    out.push(...tokens.slice(done, from), ...shortened(tokens.slice(from, to)));
    done = to;
  }
  return joined([...out, ...tokens.slice(done)]);
}
