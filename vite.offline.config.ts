import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve, sep } from 'node:path';
import { defineConfig } from 'vite';
import { keptFromTheStart } from './src/site/kept-files.ts';

const outDir = resolve(import.meta.dirname, process.env.WINDGROVE_TEST_BUILD ?? 'dist');
const source = (name: string): string => resolve(import.meta.dirname, 'src/site', name);
const bytes = (path: string): Buffer => readFileSync(join(outDir, path));
const hashOf = (content: Buffer | string): string => createHash('sha256').update(content).digest('hex').slice(0, 12);

/** Of each file that is kept from the start its address and, where its name does not say it, its content. */
function kept(): { url: string; revision: string | null }[] {
  const files = readdirSync(outDir, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) =>
      join(entry.parentPath, entry.name)
        .slice(outDir.length + 1)
        .replaceAll(sep, '/'),
    );
  return keptFromTheStart({ files, text: (path) => bytes(path).toString() }).map((url) => ({
    url,
    revision: url.startsWith('assets/') ? null : hashOf(bytes(url)),
  }));
}

/** The last step of the site: what keeps it for when there is no network, and so has to know its files. */
export default defineConfig(() => {
  const list = kept();
  const size = list.reduce((sum, { url }) => sum + bytes(url).length, 0);
  console.log(`kept from the first visit: ${list.length} files, ${(size / 1e6).toFixed(1)} MB before packing`);
  return {
    base: './',
    publicDir: false as const,
    define: {
      KEPT_FROM_THE_START: JSON.stringify(list),
      SITE_VERSION: JSON.stringify(hashOf(JSON.stringify(list))),
      'process.env.NODE_ENV': '"production"',
    },
    build: {
      target: 'es2023',
      outDir,
      emptyOutDir: false,
      rollupOptions: {
        input: { keep: source('keep.ts'), 'service-worker': source('service-worker.ts') },
        output: { entryFileNames: '[name].js' },
      },
    },
  };
});
