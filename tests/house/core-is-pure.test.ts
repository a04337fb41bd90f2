import { join } from 'node:path';
import ts from 'typescript';
import { expect, test } from 'vitest';
import { filesUnder, root, textOf } from './tree-files.ts';

const core = filesUnder('src/core').filter((file) => file.endsWith('.ts'));

/** What Node, worker and page all have beside the language: text and addresses, which neither wait nor look around. */
const everywhere = `
  declare class TextEncoder { encode(text?: string): Uint8Array<ArrayBuffer>; }
  declare class TextDecoder {
    constructor(label?: string, options?: { fatal?: boolean });
    decode(bytes?: ArrayBuffer | ArrayBufferView): string;
  }
  declare class URLSearchParams {
    constructor(init?: string | Record<string, string> | string[][]);
    append(name: string, value: string): void;
    delete(name: string): void;
    get(name: string): string | null;
    getAll(name: string): string[];
    has(name: string): boolean;
    set(name: string, value: string): void;
    keys(): IterableIterator<string>;
    values(): IterableIterator<string>;
    entries(): IterableIterator<[string, string]>;
    [Symbol.iterator](): IterableIterator<[string, string]>;
  }
  declare function atob(text: string): string;
  declare function btoa(text: string): string;
  declare function structuredClone<T>(value: T): T;
`;

/** Names of the language itself that read a clock or draw a number that no seed decides. */
const impure = /\bMath\s*\.\s*random\b|\bDate\b|\bTemporal\b|\bperformance\b/;

/** The text without comments, where a clock may well be spoken of. */
const code = (text: string): string => text.replace(/\/\*[\s\S]*?\*\/|(?<![:'"`])\/\/.*$/gm, '');

test('core compiles with the bare language: no DOM, no Node, no GPU', () => {
  const options: ts.CompilerOptions = {
    target: ts.ScriptTarget.ES2023,
    lib: ['lib.es2023.d.ts'],
    types: [],
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    strict: true,
    allowImportingTsExtensions: true,
    resolveJsonModule: true,
    skipLibCheck: true,
    noEmit: true,
  };
  const declared = join(root, 'tests/house/everywhere.d.ts');
  const host = ts.createCompilerHost(options);
  const { getSourceFile } = host;
  host.getSourceFile = (name, ...rest) =>
    name === declared
      ? ts.createSourceFile(name, everywhere, ts.ScriptTarget.ES2023)
      : getSourceFile.call(host, name, ...rest);
  const program = ts.createProgram([declared, ...core.map((file) => join(root, file))], options, host);
  const faults = ts
    .getPreEmitDiagnostics(program)
    .map(({ file, messageText }) => `${file?.fileName}: ${ts.flattenDiagnosticMessageText(messageText, ' ')}`);
  expect(faults).toEqual([]);
});

test('core reads no clock and draws no unseeded number', () => {
  expect(core.filter((file) => impure.test(code(textOf(file))))).toEqual([]);
});

/** What engines may round differently in the last bit: the rest of a tree's arithmetic is exact by the standard. */
const perEngine =
  /\bMath\s*\.\s*(?:a?(?:sin|cos|tan)h?|atan2|cbrt|exp(?:m1)?|hypot|log(?:10|1p|2)?|pow)\b|\*\*(?!\s*2\b)/;

test('what makes a tree from its seed asks no engine for a sine, a power or a logarithm: the same link, the same tree', () => {
  for (const asked of ['Math.atan2(1, 2)', 'Math.hypot(a)', 'u ** 4']) expect(perEngine.test(asked)).toBe(true);
  // `trig.ts` has the wind's power beside the polynomials that growing uses.
  const growing = core.filter((file) => /^src\/core\/(grow|pieces|pack|math)\/(?!trig)/.test(file));
  expect(growing.length).toBeGreaterThan(20);
  expect(growing.filter((file) => perEngine.test(code(textOf(file))))).toEqual([]);
});

test('nothing in src draws an unseeded number from Math: a new seed comes from the crypto of the page', () => {
  const sources = filesUnder('src').filter((file) => file.endsWith('.ts'));
  expect(sources.filter((file) => /\bMath\s*\.\s*random\b/.test(code(textOf(file))))).toEqual([]);
});
