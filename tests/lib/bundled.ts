import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build, type Rolldown } from 'vite';

/** One file that a bundler made of a program that uses the package. */
export interface Bundled {
  readonly file: string;
  readonly text: string;
  /** Bytes, gzipped. */
  readonly size: number;
  readonly entry: boolean;
  /** Files that it needs at once. */
  readonly needs: readonly string[];
  /** Paths of the modules in it. */
  readonly modules: readonly string[];
}

/** What Vite makes of a program in a project; three stays outside. */
export async function bundle(project: string, name: string, program: string): Promise<Bundled[]> {
  const entry = join(project, `${name}.js`);
  writeFileSync(entry, program);
  const { NODE_ENV } = process.env;
  // As whoever ships builds it: as a test, Lit would come with its warnings for developers, which are 4 kB.
  process.env.NODE_ENV = 'production';
  const result = await build({
    root: project,
    configFile: false,
    logLevel: 'error',
    build: {
      write: false,
      target: 'es2023',
      minify: true,
      lib: { entry, formats: ['es'], fileName: name },
      rollupOptions: { external: /^three(\/|$)/, output: { minify: true } },
    },
  });
  process.env.NODE_ENV = NODE_ENV;
  const outputs = (Array.isArray(result) ? result : [result]) as Rolldown.RolldownOutput[];
  return outputs
    .flatMap(({ output }) => output)
    .map((one) => {
      const text = one.type === 'chunk' ? one.code : String(one.source);
      return {
        file: one.fileName,
        text,
        size: gzipSync(text, { level: 9 }).length,
        entry: one.type === 'chunk' && one.isEntry,
        needs: one.type === 'chunk' ? one.imports : [],
        modules: one.type === 'chunk' ? Object.keys(one.modules) : [],
      };
    });
}

/** The files that come with these, themselves included, and nothing that is loaded later. */
export function withNeeds(all: readonly Bundled[], first: readonly Bundled[]): Bundled[] {
  const found = new Set<Bundled>();
  const take = (one: Bundled): void => {
    if (found.has(one)) return;
    found.add(one);
    for (const need of one.needs) for (const other of all) if (other.file === need) take(other);
  };
  first.forEach(take);
  return [...found];
}

export const sizeOf = (files: readonly Bundled[]): number => files.reduce((sum, { size }) => sum + size, 0);
