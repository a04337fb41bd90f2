import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

/** Lines of a file: from line 1 on, both ends included. */
export interface Lines {
  readonly from: number;
  readonly to: number;
}

const GLSL = /\.(glsl|vert|frag)$/;

/** The text of a file of the repository. Throws, with its path, where there is none. */
export function sourceText(file: string): string {
  if (!/^(src|shaders)\/[\w./-]+\.(ts|glsl|vert|frag)$/.test(file) || file.includes('..'))
    throw new Error(`<source-lines>: '${file}' is no source file below src/ or shaders/.`);
  try {
    return readFileSync(resolve(import.meta.dirname, '..', file), 'utf8');
  } catch {
    throw new Error(`<source-lines>: there is no file '${file}'.`);
  }
}

/**
 * Where a file declares `name` (`Class.method` for a method), with the comment above it. Throws where it does not, so that no lesson cites what
 * has gone.
 */
export async function linesOf(file: string, text: string, name: string): Promise<Lines> {
  const found = GLSL.test(file) ? glslLines(text, name) : await typescriptLines(file, text, name);
  if (found) return found;
  throw new Error(`<source-lines>: ${file} ${GLSL.test(file) ? 'has no' : 'exports no'} '${name}'.`);
}

async function typescriptLines(file: string, text: string, name: string): Promise<Lines | null> {
  // Large: loaded where a lesson is built, and by nothing else.
  const { default: ts } = await import('typescript');
  const source = ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true);
  const [outer, inner] = name.split('.');
  for (const statement of source.statements) {
    if (!ts.canHaveModifiers(statement)) continue;
    if (!ts.getModifiers(statement)?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword)) continue;
    const named = ts.isVariableStatement(statement)
      ? statement.declarationList.declarations.some((each) => each.name.getText(source) === outer)
      : 'name' in statement && (statement.name as { text?: string } | undefined)?.text === outer;
    if (!named) continue;
    if (inner === undefined) return range(source, statement);
    const member =
      ts.isClassDeclaration(statement) && statement.members.find((each) => each.name?.getText(source) === inner);
    if (member) return range(source, member);
  }
  return null;

  function range(of: import('typescript').SourceFile, node: import('typescript').Node): Lines {
    const line = (at: number): number => of.getLineAndCharacterOfPosition(at).line + 1;
    return { from: line(node.getStart(of, true)), to: line(node.getEnd()) };
  }
}

/** A function, structure or constant of a shader, from the comment above it to its closing bracket. */
function glslLines(text: string, name: string): Lines | null {
  const lines = text.split('\n');
  const word = name.replaceAll(/[^\w]/g, '');
  const head = new RegExp(
    `^(?:[\\w ]+\\s${word}\\s*\\(|struct\\s+${word}\\b|const\\s+\\w+\\s+${word}\\b|#define\\s+${word}\\b)`,
  );
  // A declaration that ends at once is not what is looked for.
  const at = lines.findIndex((line) => head.test(line) && !/^[\w ]+\([^{]*\)\s*;/.test(line));
  if (at < 0) return null;
  let to = at;
  if (!/^(const|#define)/.test(lines[at]!)) {
    let depth = 0;
    let opened = false;
    for (; to < lines.length; to++) {
      const code = lines[to]!.replace(/\/\/.*$/, '');
      for (const sign of code) depth += sign === '{' ? 1 : sign === '}' ? -1 : 0;
      opened ||= code.includes('{');
      if (opened && depth === 0) break;
    }
  }
  let from = at;
  while (from > 0 && /^\s*(\/\/|\/\*|\*)/.test(lines[from - 1]!)) from--;
  return { from: from + 1, to: Math.min(lines.length, to + 1) };
}

const escaped = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

const WORDS =
  'export|import|from|const|let|function|return|if|else|for|while|of|in|new|class|extends|readonly|interface|type|static|async|await|yield|switch|case|throw|uniform|attribute|varying|struct|void|float|int|uint|bool|vec[234]|mat[234]|quat';
const TOKEN = new RegExp(
  `(\\/\\*[\\s\\S]*?\\*\\/|\\/\\/[^\\n]*)|('(?:[^'\\\\\\n]|\\\\.)*'|\`(?:[^\`\\\\]|\\\\.)*\`)|\\b(${WORDS})\\b`,
  'g',
);

/** The lines as HTML: comments are soft, the language's own words bold. `anchors`: each line has an id, `L12`. */
export function codeHtml(text: string, { from, to }: Lines, anchors = false): string {
  const marked = text.replaceAll(/\r/g, '');
  let html = '';
  let last = 0;
  for (const match of marked.matchAll(TOKEN)) {
    html += escaped(marked.slice(last, match.index));
    const [whole, comment, , word] = match;
    // A comment over several lines is marked on each of them.
    if (comment)
      html += whole
        .split('\n')
        .map((line) => `<i>${escaped(line)}</i>`)
        .join('\n');
    else html += word ? `<b>${whole}</b>` : escaped(whole);
    last = match.index + whole.length;
  }
  html += escaped(marked.slice(last));
  return html
    .split('\n')
    .slice(from - 1, to)
    .map((line, i) => `<span${anchors ? ` id="L${from + i}"` : ''} data-line="${from + i}">${line || ' '}</span>`)
    .join('');
}
