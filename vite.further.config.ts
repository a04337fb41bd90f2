import { resolve } from 'node:path';
import { mergeConfig } from 'vite';
import base from './vite.config.ts';

/**
 * The pages beside the editor, built after it into the same folder. In one build with them its code falls into eighty files in place of thirty, which
 * pack worse: 372 kB in place of 349 travelled before the first tree moved.
 */
const pages = ['forest.html', 'range.html', 'bench.html'];

export default mergeConfig(
  { ...base, build: { ...base.build, rollupOptions: {} } },
  {
    publicDir: false,
    build: {
      emptyOutDir: false,
      rollupOptions: { input: pages.map((page) => resolve(import.meta.dirname, page)) },
    },
  },
);
