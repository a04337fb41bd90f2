import ts from 'typescript';
import { describe, expect, test } from 'vitest';
import { exists } from './imports.ts';
import { filesUnder, textOf } from './tree-files.ts';

interface GlslFunction {
  readonly file: string;
  readonly name: string;
  /** The comment that ends on the line above; empty where there is none. */
  readonly doc: string;
  /** File of the twin: named by the doc block, else by the comment that opens the file; undefined where neither does. */
  readonly twin: string | undefined;
}

/** A comment block or a run of line comments, then a function with a body at the start of a line. */
const definition =
  /((?:\/\*(?:[^*]|\*(?!\/))*\*\/[ \t]*\n)|(?:[ \t]*\/\/[^\n]*\n)+)?^(?:(?:lowp|mediump|highp)\s+)?[A-Za-z]\w*\s+([A-Za-z]\w*)\s*\([^;{}()]*\)\s*\{/gm;

function functionsOf(file: string, text: string): GlslFunction[] {
  const matches = [...text.matchAll(definition)];
  const ofFile = twinIn(text.slice(0, matches[0]?.index));
  return matches
    .map((match) => ({ file, name: match[2]!, doc: match[1] ?? '', twin: twinIn(match[1] ?? '') ?? ofFile }))
    .filter(({ name }) => name !== 'main');
}

const twinIn = (comment: string): string | undefined => /\bTwin:\s*(\S+\.ts\b(?: \(\w+\))?)/.exec(comment)?.[1];

/** Names that a TypeScript file exports as functions. */
function exportsOf(file: string): string[] {
  const source = ts.createSourceFile(file, textOf(file), ts.ScriptTarget.Latest, true);
  return source.statements.flatMap((statement) => {
    const modifiers = ts.canHaveModifiers(statement) ? ts.getModifiers(statement) : undefined;
    if (!modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword)) return [];
    if (ts.isFunctionDeclaration(statement)) return [statement.name!.text];
    if (ts.isVariableStatement(statement)) {
      return statement.declarationList.declarations.map(({ name }) => name.getText(source));
    }
    return [];
  });
}

/** What is wrong with the doc block of a function, or undefined. */
function fault({ file, name, doc, twin }: GlslFunction): string | undefined {
  if (doc === '') return `${file}: ${name} has no doc block`;
  if (!twin) return `${file}: neither the doc block of ${name} nor its file names a twin ('Twin: src/core/...')`;
  // A twin that GLSL cannot give the same name (it has no optional arguments) is named in brackets.
  const [, path, other] = /^(\S+)(?: \((\w+)\))?$/.exec(twin)!;
  if (!path!.startsWith('src/core/')) return `${file}: the twin of ${name} is outside of core: ${path}`;
  if (!exists(path!)) return `${file}: the twin of ${name} is not there: ${path}`;
  return exportsOf(path!).includes(other ?? name) ? undefined : `${file}: ${path} exports no ${other ?? name}`;
}

/** Functions that draw rather than compute: three's own hooks and what only they call, which pictures judge. */
const drawing = new Set([
  'gloss',
  'barkOwnTexel',
  'barkOwn',
  'leafAnswer',
  'RE_Direct_Leaf',
  'RE_IndirectDiffuse_Leaf',
  'RE_Direct_Far',
  'farLit',
  'farCatch',
  'farWay',
  'terrainShadow',
  'terrainNormal',
  'crownLaid',
  'laidColour',
]);

/** A file that reads or writes what flows through the pipeline: glue between libraries, whose whole is compared as a drawn tree. */
function isGlue(file: string): boolean {
  const text = textOf(file);
  if (/^[ \t]*(?:(?:flat|layout\([^)]*\))\s+)*(?:uniform|in|out)\s/m.test(text)) return true;
  return [...text.matchAll(/^[ \t]*#include\s+\/(\S+)/gm)].some((match) => isGlue(`shaders/${match[1]}`));
}

/** What shaders are put together from; debug/ holds what only cross-check and bench draw with. */
const files = ['lib', 'wind', 'branch', 'leaf', 'forest']
  .flatMap((folder) => filesUnder(`shaders/${folder}`))
  .filter((file) => file.endsWith('.glsl'));
const functions = files
  .flatMap((file) => functionsOf(file, textOf(file)))
  .filter(({ file, name, twin }) => !drawing.has(name) && (twin || file.startsWith('shaders/lib/') || !isGlue(file)));

describe('twins', () => {
  test('every file of shaders says what it is for before its first function', () => {
    const silent = files.filter((file) => {
      const [before] = textOf(file).split(/^[A-Za-z]\w*\s+\w+\s*\(/m);
      return !/^[ \t]*(\/\/|\/\*)/m.test(before!);
    });
    expect(silent).toEqual([]);
  });

  test('every function of the shader libraries names a TypeScript function of core that exists', () => {
    expect(functions.length).toBeGreaterThan(0);
    expect(functions.map(fault).filter(Boolean)).toEqual([]);
  });

  test('the reader of shaders finds functions, their doc blocks, and those that have none', () => {
    const text = `
/** Sine of turns.\n * Twin: src/core/math/trig.ts */
float sinTurns(float x) {
  if (x > 0.0) { return x; }
  return 0.0;
}
// One.
// Twin: src/core/math/bezier.ts
vec3 bezierPoint(
  Cubic c,
  float u
) { return c.p0; }

highp vec3 bare(vec3 a) {
  return a;
}
vec3 declared(vec3 a);
void main() { gl_Position = vec4(0.0); }
`;
    const found = functionsOf('x.glsl', text);
    expect(found.map(({ name }) => name)).toEqual(['sinTurns', 'bezierPoint', 'bare']);
    expect(found.map(({ twin }) => twin)).toEqual(['src/core/math/trig.ts', 'src/core/math/bezier.ts', undefined]);
    expect(fault(found[2]!)).toMatch(/no doc block/);
    expect(fault({ ...found[0]!, name: 'noSuchName' })).toMatch(/exports no noSuchName/);
    expect(functionsOf('y.glsl', '// All of: Twin: src/core/a.ts\n\n// A.\nint a(int b) {\n}\n')[0]!.twin).toBe(
      'src/core/a.ts',
    );
  });
});

describe('includes', () => {
  test('every include of a shader is a file of shaders', () => {
    const missing = filesUnder('shaders').flatMap((file) =>
      [...textOf(file).matchAll(/^[ \t]*#include\s+["<]?([^\s">;]+)[">]?/gm)]
        .map((match) => match[1]!)
        // three's own chunks are in angle brackets without an ending; ours have one.
        .filter((path) => /\.(glsl|vert|frag)$/.test(path))
        .filter((path) => {
          const target = path.startsWith('/')
            ? path.replace(/^\/(shaders\/)?/, 'shaders/')
            : new URL(path, `file:///${file}`).pathname.slice(1);
          return !exists(target);
        })
        .map((path) => `${file}: ${path}`),
    );
    expect(missing).toEqual([]);
  });
});
