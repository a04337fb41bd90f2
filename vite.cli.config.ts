import { chmodSync, cpSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig } from 'vite';

const out = join(import.meta.dirname, 'dist-cli');

/** Builds the `windgrove` command: one file for Node, with the shipped species beside it. */
export default defineConfig({
  publicDir: false,
  build: {
    ssr: join(import.meta.dirname, 'src/cli/main.ts'),
    outDir: out,
    emptyOutDir: true,
    target: 'node20',
    rollupOptions: { output: { entryFileNames: 'main.js' } },
  },
  plugins: [
    {
      name: 'ship-species',
      closeBundle() {
        cpSync(join(import.meta.dirname, 'public/species'), join(out, 'species'), { recursive: true });
        chmodSync(join(out, 'main.js'), 0o755);
      },
    },
  ],
});
