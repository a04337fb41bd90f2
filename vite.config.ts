import { existsSync, readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';

/** Pages that ship; each is an entry of the build. */
const pages = ['index.html', 'crosscheck.html'];

/** The browser tests build into a folder of their own (playwright.config.ts), with pages that only they look at. */
const testBuild = process.env.WINDGROVE_TEST_BUILD;
const testPages = resolve(import.meta.dirname, 'e2e/pages');
if (testBuild && existsSync(testPages)) {
  const names = readdirSync(testPages).filter((name) => name.endsWith('.html'));
  pages.push(...names.map((name) => `e2e/pages/${name}`));
}

/** `npm start` opens the editor where there is a desktop to open it on; elsewhere the printed address has to do. */
const desktop = process.platform !== 'linux' || Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);

export default defineConfig({
  base: './',
  server: { open: desktop && process.env.npm_lifecycle_event === 'start' },
  preview: { open: false },
  // Each file guards itself: two that include the same third are no mistake.
  plugins: [glsl({ root: '/shaders/', warnDuplicatedImports: false })],
  worker: { format: 'es' },
  build: {
    target: 'es2023',
    outDir: testBuild ?? 'dist',
    emptyOutDir: true,
    rollupOptions: { input: pages.map((page) => resolve(import.meta.dirname, page)) },
  },
});
