import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync, statSync } from 'node:fs';
import { builtinModules, createRequire } from 'node:module';
import { dirname, join, posix } from 'node:path';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import ts from 'typescript';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { hashPacked } from '../../src/core/pack/hash-packed.ts';
import { parseSpecies } from '../../src/core/species/parse.ts';
import { bundle, sizeOf, withNeeds } from './bundled.ts';
import { examples, runInNode, typeFaults } from './examples.ts';
import { filesOf, type Manifest, manifestOf, packed, project } from './packed.ts';

// The npm package as it would be published: built, packed, unpacked, and used from a folder that knows nothing of this one.
const root = join(import.meta.dirname, '../..');
let folder = '';
let place = '';
let files: string[] = [];
let manifest: Manifest;

beforeAll(() => {
  folder = packed();
  files = filesOf(folder);
  manifest = manifestOf(folder);
  place = project(folder, ['three', '@types/three']);
}, 240_000);

afterAll(() => {
  if (place) rmSync(place, { recursive: true, force: true });
});

const read = (file: string): string => readFileSync(join(folder, 'package', file), 'utf8');
/** What a file imports, whatever its texts and comments say. */
const importsOf = (file: string): string[] =>
  ts.preProcessFile(read(file), true, true).importedFiles.map(({ fileName }) => fileName);
const packageOf = (name: string): string =>
  name
    .split('/')
    .slice(0, name.startsWith('@') ? 2 : 1)
    .join('/');

/** Workers and the script for a page are whole; the rest asks for packages by name. */
const isWhole = (file: string): boolean => /\.worker\.js$|dist-lib\/windgrove\.js$/.test(file);
const modules = (): string[] => files.filter((file) => file.endsWith('.js') && !isWhole(file));

describe('the package', () => {
  it('has what is used, and no sources, tests or pictures', () => {
    const kinds = new Set(files.map((file) => file.replace(/^.*?((\.d)?\.\w+|\/?[A-Z]+)$/, '$1')));
    expect([...kinds].filter((kind) => !['.js', '.d.ts', '.json', '.csv', '.md', 'LICENSE'].includes(kind))).toEqual(
      [],
    );
    expect(files.filter((file) => !/^(dist-lib|dist-cli)\//.test(file))).toEqual(
      ['LICENSE', 'README.md', 'custom-elements.json', 'package.json'].filter((file) => files.includes(file)),
    );
    const bytes = statSync(join(folder, 'windgrove.tgz')).size;
    console.log(`npm package: ${files.length} files, ${(bytes / 1000).toFixed(0)} kB packed`);
    expect(bytes).toBeLessThan(1_600_000);
  });

  it('asks for exactly the packages that its code imports', () => {
    const asked = new Set(
      modules()
        .flatMap(importsOf)
        .filter((name) => !name.startsWith('.')),
    );
    const packages = new Set([...asked].filter((name) => !isNode(name)).map(packageOf));
    const peers = Object.keys(manifest.peerDependencies).filter((name) => !name.startsWith('@types/'));
    expect([...packages].sort()).toEqual([...Object.keys(manifest.dependencies), ...peers].sort());
    expect(files.filter((file) => file.startsWith('dist-lib/') && file.endsWith('.js') && isWhole(file))).not.toEqual(
      [],
    );
  });

  it('has every file that another of its files names', () => {
    const missing = files
      .filter((file) => /\.(d\.ts|js)$/.test(file) && !isWhole(file))
      .flatMap((file) => {
        const beside = [...read(file).matchAll(/new URL\("(\.\/[^"]+)", import\.meta\.url\)/g)].map(
          ([, name]) => name!,
        );
        return [...importsOf(file).filter((name) => name.startsWith('.')), ...beside].map((name) => {
          const target = posix.join(dirname(file), name);
          return file.endsWith('.d.ts') ? target.replace(/\.js$/, '.d.ts') : target;
        });
      })
      .filter((target) => !files.includes(target));
    expect([...new Set(missing)]).toEqual([]);
  });

  it('starts its workers in the words that bundlers look for, each from a file that is whole', () => {
    const workers = modules().flatMap((file) =>
      [...read(file).matchAll(/new Worker\(new URL\("(\.\/[\w-]+\.worker\.js)", import\.meta\.url\)/g)].map(
        ([, name]) => posix.join(dirname(file), name!),
      ),
    );
    expect(workers.length).toBeGreaterThanOrEqual(3);
    for (const worker of workers) expect(importsOf(worker), worker).toEqual([]);
  });

  it('passes publint', async () => {
    const { messages } = await publint({ pkgDir: join(folder, 'package'), pack: false, strict: true });
    const pkg = JSON.parse(read('package.json')) as Record<string, unknown>;
    expect(messages.map((message) => formatMessage(message, pkg))).toEqual([]);
  });

  it('passes Are the types wrong, as a package of modules', async () => {
    const result = await checkPackage(createPackageFromTarballData(readFileSync(join(folder, 'windgrove.tgz'))));
    if (!result.types) throw new Error('no types');
    // require() of a module, and TypeScript's ways from before there were `exports`, are not for a package of modules.
    const old = (kind: string | undefined): boolean => kind === 'node10' || kind === 'node16-cjs';
    const faults = result.problems.filter((each) => !('resolutionKind' in each && old(each.resolutionKind)));
    expect(faults).toEqual([]);
    expect(Object.keys(result.entrypoints)).toEqual(Object.keys(manifest.exports));
  });
});

const isNode = (name: string): boolean => name.startsWith('node:') || builtinModules.includes(name);

describe('windgrove/core', () => {
  it('grows in Node the tree that the page grows', () => {
    const node = project(folder, [], 'node');
    try {
      const out = execFileSync(process.execPath, ['main.mjs'], { cwd: node, encoding: 'utf8' });
      const { species } = parseSpecies(readFileSync(join(root, 'public/species/quaking-aspen.json'), 'utf8'));
      const hash = hashPacked(growPacked(species!, 1).packed);
      expect(out).toContain(`hash ${hash}\n`);
      expect(existsSync(join(node, 'quaking-aspen-1.swc'))).toBe(true);
    } finally {
      rmSync(node, { recursive: true });
    }
  });

  it('leads to nothing of three, the page or the element', () => {
    const seen = new Set<string>();
    const packages = new Set<string>();
    const walk = (file: string): void => {
      if (seen.has(file)) return;
      seen.add(file);
      for (const name of importsOf(file)) {
        if (name.startsWith('.')) walk(posix.join(dirname(file), name));
        else packages.add(packageOf(name));
      }
    };
    walk('dist-lib/lib/core.js');
    expect(seen.size).toBeGreaterThan(100);
    expect([...packages]).not.toContain('three');
    expect([...packages]).not.toContain('lit');
    expect([...seen].filter((file) => /dist-lib\/(gpu|shaders|worker)\//.test(file))).toEqual([]);
  });
});

describe('sizes', () => {
  it('parseSpecies alone is a few kilobytes', async () => {
    const made = await bundle(
      place,
      'parse',
      "import { parseSpecies } from 'windgrove/core'; console.log(parseSpecies('{}'));",
    );
    console.log(`only parseSpecies: ${sizeOf(made)} bytes, gzipped`);
    expect(made).toHaveLength(1);
    expect(made[0]!.needs).toEqual([]);
    expect(sizeOf(made)).toBeLessThan(10_000);
  });

  it('WindTree alone brings no forest, stage, growing or export', async () => {
    const made = await bundle(place, 'tree', "import { WindTree } from 'windgrove'; console.log(new WindTree());");
    const now = withNeeds(
      made,
      made.filter(({ entry }) => entry),
    );
    console.log(`only WindTree: ${sizeOf(now)} bytes, gzipped, without three`);
    expect(sizeOf(now)).toBeLessThan(70_000);
    const inside = now.flatMap((one) => one.modules).filter((id) => id.includes('/windgrove/'));
    expect(inside.length).toBeGreaterThan(50);
    expect(
      inside.filter((id) =>
        /forest\/(?!grove-shader)|view\/stage\.js|core\/(grow\/grow|io\/export|species\/para)|worker\/remote/.test(id),
      ),
    ).toEqual([]);
  });

  // What is counted: every script that the page and its worker ask for until the first frame of `<wind-tree species="quaking-aspen">`
  // moves, minified by Vite, gzipped at level 9, file by file, without three.
  it('the element loads little until a tree is near, and of bark, leaves and the rest what that tree needs', async () => {
    const made = await bundle(place, 'element', "import 'windgrove/element';");
    const has = (one: { modules: readonly string[]; file: string }, path: string): boolean =>
      one.file.includes(path) || one.modules.some((id) => id.endsWith(path));
    const first = made.filter(({ entry }) => entry);
    expect(first[0]!.text).toContain('customElements.define');
    const eager = withNeeds(made, first);
    const chunkOf = (path: string) => {
      const found = made.filter((one) => has(one, path));
      expect(found, path).toHaveLength(1);
      return found[0]!;
    };
    const [worker, ...shown] = ['grow.worker', 'element/drawing.js', ...ASPEN].map(chunkOf);
    const all = withNeeds(made, [...first, worker!, ...shown]);
    const page = sizeOf(all) - worker!.size;
    console.log(
      `the element: ${sizeOf(eager)} bytes at once, ${page} in the page and ${worker!.size} in the worker to show a tree, gzipped, without three`,
    );
    expect(sizeOf(eager)).toBeLessThan(17_200);
    expect(page).toBeLessThan(89_000);
    expect(page + worker!.size).toBeLessThan(107_100);
    // Each is a request, and packs worse than in one with the others.
    expect(all.length).toBeLessThanOrEqual(18);
    const inside = all.flatMap((one) => one.modules);
    expect(inside.filter((id) => NOT_YET.test(id))).toEqual([]);
    // They are in what comes later, and not gone.
    for (const path of LATER) chunkOf(path);
  });
});

/** What an aspen in a breeze is made with: its own files, its bark and its leaf. */
const ASPEN = ['species/quaking-aspen.js', 'winds/breeze.js', 'core/look/bark-smooth.js', 'core/look/paper-forms.js'];

/** Tables, export, the CPU's wind, other barks and leaves, what is shown to those who look inside, hands on the camera, and Lit's templates. */
const NOT_YET =
  /core\/species\/(parameters|parse)|core\/io\/|gltf|\/editor\/|cpu-poser|pose-tree|view\/(bark-own|pick|control-lines|overlay|whole-kit)|bark-(furrowed|plated|peeling|stringy|palm|ribbed|noded|image)\.|organ-mesh|needle-shapes|compound-leaves|leaf-shapes|element\/(debug|element-wind|element-files|orbit-input)|view\/(stage\.|channel-shader|picture\/capture)|lit-html/;
const LATER = [
  'core/look/bark-palm.js',
  'core/look/organ-mesh.js',
  'view/bark-own.js',
  'gpu/cpu-poser.js',
  'element/debug-state.js',
  'element/orbit-input.js',
];

describe('the examples of the reference', () => {
  it('are right by the types of the package', () => {
    expect(examples().length).toBeGreaterThan(7);
    expect(typeFaults(place, examples())).toEqual([]);
  });

  it('run in Node, where they need no page', () => {
    const pure = examples().filter((text) => !/from '(?!windgrove\/core')/.test(text));
    expect(pure.length).toBeGreaterThan(4);
    const said = runInNode(place, pure);
    expect(said).toContain('Weeping Willow Gale');
    expect(said).not.toMatch(/NaN|undefined/);
  });
});

describe('the oldest three', () => {
  it('has every name that the package imports from three', () => {
    const oldest = createRequire(import.meta.url)('three-oldest') as Record<string, unknown>;
    const names = new Set<string>();
    for (const file of modules())
      for (const [, list] of read(file).matchAll(/import \{([^}]+)\} from "three"/g))
        for (const name of list!.split(',')) names.add(name.trim().split(' ')[0]!);
    expect(names.size).toBeGreaterThan(50);
    expect([...names].filter((name) => !(name in oldest))).toEqual([]);
  });
});
