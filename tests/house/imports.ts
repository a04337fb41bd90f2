import { existsSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import ts from 'typescript';
import { root, textOf } from './tree-files.ts';

/** One import: by whom, what it names, and the file or package that this is. */
export interface Import {
  readonly file: string;
  readonly specifier: string;
  /** Path of the imported file in the repository, without query; undefined for packages. */
  readonly target: string | undefined;
  /** Name of the imported package ('node:fs' for Node's own); undefined for files. */
  readonly package: string | undefined;
}

const packageOf = (specifier: string): string =>
  specifier
    .split('/')
    .slice(0, specifier.startsWith('@') ? 2 : 1)
    .join('/');

/** Every import of a TypeScript file: static, re-exported, dynamic, of a type, and `new URL(..., import.meta.url)` of workers. */
export function importsOf(file: string): Import[] {
  const source = ts.createSourceFile(file, textOf(file), ts.ScriptTarget.Latest, true);
  const specifiers: string[] = [];
  const visit = (node: ts.Node): void => {
    if ((ts.isImportDeclaration(node) || ts.isExportDeclaration(node)) && node.moduleSpecifier) {
      if (ts.isStringLiteral(node.moduleSpecifier)) specifiers.push(node.moduleSpecifier.text);
    } else if (ts.isCallExpression(node) && node.expression.kind === ts.SyntaxKind.ImportKeyword) {
      const argument = node.arguments[0];
      specifiers.push(argument && ts.isStringLiteralLike(argument) ? argument.text : 'computed at run time');
    } else if (ts.isImportTypeNode(node) && ts.isLiteralTypeNode(node.argument)) {
      if (ts.isStringLiteral(node.argument.literal)) specifiers.push(node.argument.literal.text);
    } else if (ts.isNewExpression(node) && node.expression.getText(source) === 'URL') {
      const [path, base] = node.arguments ?? [];
      if (path && ts.isStringLiteral(path) && base?.getText(source) === 'import.meta.url') specifiers.push(path.text);
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return specifiers.map((specifier) => resolved(file, specifier));
}

function resolved(file: string, specifier: string): Import {
  const path = specifier.split('?')[0]!;
  if (path.startsWith('.')) {
    return { file, specifier, target: posix.join(dirname(file), path), package: undefined };
  }
  if (path.startsWith('/')) return { file, specifier, target: path.slice(1), package: undefined };
  return { file, specifier, target: undefined, package: packageOf(path) };
}

/** Whether the imported file is there. */
export const exists = (target: string): boolean => existsSync(join(root, target));
