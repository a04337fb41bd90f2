import { chmodSync, cpSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig } from 'vite';

/** The tests of the package build into a folder of their own (tests/lib/packed.ts). */
const out = process.env.WINDGROVE_CLI_BUILD ?? join(import.meta.dirname, 'dist-cli');
const source = (file: string): string => join(import.meta.dirname, 'src/cli', file);

/**
 * Builds the `windgrove` command for Node, with the species and winds that ship beside it.
 *
 * All its files lie in one folder: they find each other, the thread of a bake, and what ships by it.
 */
export default defineConfig({
  publicDir: false,
  build: {
    ssr: true,
    outDir: out,
    emptyOutDir: true,
    target: 'node20',
    rollupOptions: {
      input: { main: source('main.ts'), 'bake-thread': source('bake-thread.ts') },
      output: { entryFileNames: '[name].js', chunkFileNames: '[name]-[hash].js' },
    },
  },
  plugins: [
    {
      name: 'ship-species-and-winds',
      closeBundle() {
        for (const folder of ['species', 'winds'])
          cpSync(join(import.meta.dirname, 'public', folder), join(out, folder), { recursive: true });
        chmodSync(join(out, 'main.js'), 0o755);
      },
    },
  ],
});
