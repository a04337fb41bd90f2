import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { mergeConfig } from 'vite';
import base from './vite.config.ts';

// The pages that only browser tests look at, built into the folder of the tested build after what ships: in one build with it
// they would take part in how its code is split, and what is measured would not be what ships.
const folder = resolve(import.meta.dirname, 'e2e/pages');
const pages = readdirSync(folder).filter((name) => name.endsWith('.html'));

export default mergeConfig(
  { ...base, build: { ...base.build, rollupOptions: {} } },
  {
    publicDir: false,
    build: { emptyOutDir: false, rollupOptions: { input: pages.map((name) => resolve(folder, name)) } },
  },
);
