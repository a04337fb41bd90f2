import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import ts from 'typescript';
import type { Plugin } from 'vite';

const root = dirname(import.meta.dirname);
const SPECIFIER = /((?:from|import)\s*\(?\s*['"])(\.{1,2}\/[^'"]+)\.ts(['"])/g;

/**
 * Writes what the entries declare, and what that needs, beside the modules: `lib/index.d.ts` for `lib/index.js`.
 *
 * Types are not checked here, which `npm test` does. Specifiers end in `.js`, as they must for whoever has no sources.
 */
export function declarations(): Plugin {
  let out = '';
  return {
    name: 'windgrove:declarations',
    configResolved(config) {
      out = resolve(config.root, config.build.outDir);
    },
    closeBundle() {
      const path = join(root, 'tsconfig.lib.json');
      const { config, error } = ts.readConfigFile(path, ts.sys.readFile);
      if (error) throw new Error(ts.flattenDiagnosticMessageText(error.messageText, '\n'));
      const { options, fileNames } = ts.parseJsonConfigFileContent(config, ts.sys, root);
      const { emitSkipped, diagnostics } = ts
        .createProgram(fileNames, options)
        .emit(undefined, (file, text) => write(join(out, relative(join(root, 'src'), file)), text), undefined, true);
      const faults = diagnostics.map((each) => ts.flattenDiagnosticMessageText(each.messageText, '\n'));
      if (emitSkipped || faults.length > 0) throw new Error(`No declarations:\n${faults.join('\n')}`);
    },
  };
}

function write(file: string, text: string): void {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text.replace(SPECIFIER, '$1$2.js$3'));
}
