import { basename, dirname, resolve } from 'node:path';
import { build, type InlineConfig, type Plugin } from 'vite';
import { shaders } from './glsl.ts';

/** How the library starts a worker: the same words in every client, so that bundlers see them, and so that these plugins do. */
const START = /new URL\('(\.\/[\w-]+\.worker)\.ts', import\.meta\.url\)/g;
const START_INLINE = /new Worker\(\s*new URL\('(\.\/[\w-]+\.worker)\.ts', import\.meta\.url\)/g;

/** A worker as one text without imports: import maps do not reach into workers, and a blob has no neighbours. */
async function workerText(file: string): Promise<string> {
  const config: InlineConfig = {
    configFile: false,
    // glTF-Transform asks for Node's files where it runs in Node: that warning is the only one.
    logLevel: 'error',
    publicDir: false,
    root: dirname(import.meta.dirname),
    plugins: [shaders()],
    build: {
      write: false,
      target: 'es2023',
      minify: true,
      rollupOptions: { input: file, output: { format: 'es', codeSplitting: false }, preserveEntrySignatures: false },
    },
  };
  const result = await build(config);
  const outputs = Array.isArray(result) ? result : [result];
  const chunks = outputs.flatMap((each) => ('output' in each ? each.output : []));
  const [chunk] = chunks;
  if (chunks.length !== 1 || chunk?.type !== 'chunk') throw new Error(`${file} is not one file`);
  return chunk.code;
}

/**
 * Workers as files beside the modules that start them: `new Worker(new URL('./grow.worker.js', import.meta.url), { type: 'module' })` is
 * what bundlers look for, and what a browser understands that has none.
 */
export function workersBeside(): Plugin {
  const PLACE = 'windgroveWorkerUrl';
  const files = new Set<string>();
  return {
    name: 'windgrove:workers-beside',
    enforce: 'pre',
    transform(code, id) {
      if (!id.endsWith('.ts') || !code.includes('.worker.ts')) return null;
      return {
        // Hidden from Vite, which would make an address of its own that no other bundler reads.
        code: code.replace(START, (_, path: string) => {
          files.add(resolve(dirname(id), `${path}.ts`));
          return `${PLACE}(${JSON.stringify(path)})`;
        }),
        map: null,
      };
    },
    renderChunk(code) {
      if (!code.includes(PLACE)) return null;
      const shown = code.replace(
        new RegExp(`${PLACE}\\(['"]([^'"]+)['"]\\)`, 'g'),
        (_, path: string) => `new URL('${path}.js', import.meta.url)`,
      );
      return { code: shown, map: null };
    },
    async generateBundle() {
      for (const file of files) {
        const name = `${basename(dirname(file))}/${basename(file, '.ts')}.js`;
        this.emitFile({ type: 'asset', fileName: name, source: await workerText(file) });
      }
    },
  };
}

/** Workers inside the file that starts them, as texts: for a script that has no neighbours. */
export function workersInside(): Plugin {
  const NAME = 'virtual:windgrove-worker:';
  return {
    name: 'windgrove:workers-inside',
    enforce: 'pre',
    resolveId: (id) => (id.startsWith(NAME) ? `\0${id}` : null),
    async load(id) {
      if (!id.startsWith(`\0${NAME}`)) return null;
      const text = await workerText(id.slice(NAME.length + 1));
      return [
        `const text = ${JSON.stringify(text)};`,
        'let address;',
        "export const start = () => (address ??= URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));",
      ].join('\n');
    },
    transform(code, id) {
      if (!id.endsWith('.ts') || !code.includes('.worker.ts')) return null;
      const imports: string[] = [];
      const inside = code.replace(START_INLINE, (_, path: string) => {
        const name = `startOfWorker${imports.length}`;
        const file = JSON.stringify(NAME + resolve(dirname(id), `${path}.ts`));
        imports.push(`import { start as ${name} } from ${file};`);
        return `new Worker(${name}()`;
      });
      return { code: `${imports.join('\n')}\n${inside}`, map: null };
    },
  };
}
