import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

const root = join(import.meta.dirname, '../..');
const cache = join(root, 'node_modules/.cache/windgrove-package');
const vite = join(root, 'node_modules/vite/bin/vite.js');

/** Everything that the package is made of. */
const SOURCES = ['src', 'shaders', 'public/species', 'public/winds'];
const FILES = [
  'package.json',
  'package-lock.json',
  'README.md',
  'LICENSE',
  'custom-elements.json',
  'tsconfig.json',
  'tsconfig.lib.json',
  'vite.cli.config.ts',
  'build/glsl.ts',
  'build/glsl-minify.ts',
  'vite.lib.config.ts',
  'build/lib-shipped.ts',
  'build/lib-types.ts',
  'build/lib-workers.ts',
];

function sources(): string[] {
  const files = FILES.filter((name) => existsSync(join(root, name)));
  const walk = (folder: string): void => {
    for (const entry of readdirSync(join(root, folder), { withFileTypes: true })) {
      const path = `${folder}/${entry.name}`;
      if (entry.isDirectory()) walk(path);
      else files.push(path);
    }
  };
  SOURCES.forEach(walk);
  return files.sort();
}

/**
 * The npm package, built, packed and unpacked as `npm install` would have it: the folder with `windgrove.tgz` and `package/`.
 *
 * Kept until a source changes, so that the unit and the browser tests of one run share it.
 */
export function packed(): string {
  const hash = createHash('sha256');
  for (const path of sources())
    hash
      .update(`${path}\0`)
      .update(readFileSync(join(root, path)))
      .update('\0');
  const kept = join(cache, hash.digest('hex').slice(0, 16));
  if (existsSync(kept)) return kept;
  mkdirSync(cache, { recursive: true });
  const making = mkdtempSync(join(cache, 'making-'));
  try {
    make(making);
    for (const name of readdirSync(cache))
      if (!name.startsWith('making-')) rmSync(join(cache, name), { recursive: true });
    renameSync(making, kept);
  } finally {
    rmSync(making, { recursive: true, force: true });
  }
  return kept;
}

/** Builds and packs in a folder that no other run uses. */
function make(folder: string): void {
  const stage = join(folder, 'stage');
  mkdirSync(stage);
  for (const name of ['package.json', 'README.md', 'LICENSE', 'custom-elements.json'])
    if (existsSync(join(root, name))) cpSync(join(root, name), join(stage, name));
  const env = {
    ...process.env,
    NODE_ENV: 'production',
    WINDGROVE_LIB_BUILD: join(stage, 'dist-lib'),
    WINDGROVE_CLI_BUILD: join(stage, 'dist-cli'),
  };
  const build = (...args: string[]): void => {
    execFileSync(process.execPath, [vite, 'build', '--logLevel', 'error', '--config', ...args], { cwd: root, env });
  };
  build('vite.lib.config.ts');
  build('vite.lib.config.ts', '--mode', 'script');
  build('vite.cli.config.ts');
  const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
  execFileSync(npm, ['pack', '--ignore-scripts', '--silent', '--pack-destination', folder], {
    cwd: stage,
    stdio: ['ignore', 'ignore', 'inherit'],
    shell: process.platform === 'win32',
  });
  const [tarball] = readdirSync(folder).filter((name) => name.endsWith('.tgz'));
  if (!tarball) throw new Error('npm pack made nothing');
  renameSync(join(folder, tarball), join(folder, 'windgrove.tgz'));
  execFileSync('tar', ['-xzf', 'windgrove.tgz'], { cwd: folder });
  rmSync(stage, { recursive: true });
}

export interface Manifest {
  readonly exports: Readonly<Record<string, string | Readonly<Record<string, string>>>>;
  readonly sideEffects: readonly string[];
  readonly dependencies: Readonly<Record<string, string>>;
  readonly peerDependencies: Readonly<Record<string, string>>;
}

export const manifestOf = (folder: string): Manifest =>
  JSON.parse(readFileSync(join(folder, 'package/package.json'), 'utf8')) as Manifest;

/** Paths of all files of the package, without `package/`. */
export function filesOf(folder: string): string[] {
  const files: string[] = [];
  const walk = (path: string): void => {
    for (const name of readdirSync(join(folder, 'package', path))) {
      const inner = path === '' ? name : `${path}/${name}`;
      if (statSync(join(folder, 'package', inner)).isDirectory()) walk(inner);
      else files.push(inner);
    }
  };
  walk('');
  return files.sort();
}

/**
 * A project far from this repository that has installed the package, what the package asks for, and `beside`; nothing else can be found from
 * there. `from`: a folder of `e2e/library` whose files it begins with.
 */
export function project(folder: string, beside: readonly string[] = [], from?: string): string {
  const place = mkdtempSync(join(tmpdir(), 'windgrove-project-'));
  const modules = join(place, 'node_modules');
  mkdirSync(modules);
  cpSync(join(folder, 'package'), join(modules, 'windgrove'), { recursive: true });
  const require = createRequire(join(root, 'package.json'));
  for (const name of [...Object.keys(manifestOf(folder).dependencies), ...beside]) {
    mkdirSync(dirname(join(modules, name)), { recursive: true });
    const there = require.resolve
      .paths(name)
      ?.map((path) => join(path, name))
      .find(existsSync);
    if (!there) throw new Error(`${name} is not installed`);
    symlinkSync(there, join(modules, name), 'junction');
  }
  writeFileSync(join(place, 'package.json'), '{ "type": "module" }\n');
  if (from) cpSync(join(root, 'e2e/library', from), place, { recursive: true });
  return place;
}
