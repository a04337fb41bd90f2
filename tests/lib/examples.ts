import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';

const lib = join(import.meta.dirname, '../../src/lib');

/** The examples in the docstrings of the library, each a program of its own. */
export const examples = (): string[] =>
  readdirSync(lib).flatMap((name) =>
    [...readFileSync(join(lib, name), 'utf8').matchAll(/^ \* ```ts\n([\s\S]*?)^ \* ```$/gm)].map(([, block]) =>
      block!.replace(/^ \* ?/gm, ''),
    ),
  );

/** What the types of the package that `project` has installed say against these programs; strict, and as TypeScript resolves for bundlers and Node. */
export function typeFaults(project: string, programs: readonly string[]): string[] {
  const files = programs.map((text, i) => {
    const file = join(project, `example-${i}.ts`);
    writeFileSync(file, `${text}\nexport {};\n`);
    return file;
  });
  const program = ts.createProgram(files, {
    target: ts.ScriptTarget.ES2023,
    module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext,
    lib: ['lib.es2023.d.ts', 'lib.dom.d.ts', 'lib.dom.iterable.d.ts'],
    types: [],
    strict: true,
    noEmit: true,
    skipLibCheck: true,
  });
  return ts.getPreEmitDiagnostics(program).map(({ file, start, messageText }) => {
    const line =
      file && start !== undefined
        ? `${file.fileName.replace(/^.*\//, '')}:${file.getLineAndCharacterOfPosition(start).line + 1} `
        : '';
    return line + ts.flattenDiagnosticMessageText(messageText, '\n');
  });
}

/** Runs the programs that need no page, one after the other in one process; what they printed. */
export function runInNode(project: string, programs: readonly string[]): string {
  const names = programs.map((text, i) => {
    const { outputText } = ts.transpileModule(text, {
      compilerOptions: { target: ts.ScriptTarget.ES2023, module: ts.ModuleKind.ESNext },
    });
    writeFileSync(join(project, `run-${i}.mjs`), outputText);
    return `./run-${i}.mjs`;
  });
  writeFileSync(join(project, 'run.mjs'), names.map((name) => `await import('${name}');`).join('\n'));
  return execFileSync(process.execPath, ['run.mjs'], { cwd: project, encoding: 'utf8' });
}
