import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { shaders } from './build/glsl.ts';
import { learn } from './build/learn.ts';
import { reference } from './build/reference.ts';
import { site } from './build/site.ts';

/** Pages that ship and are built together; vite.further.config.ts has the others, vite.pages.config.ts those of the browser tests. */
const pages = ['index.html', 'crosscheck.html'];

/** The browser tests build into a folder of their own (playwright.config.ts). */
const testBuild = process.env.WINDGROVE_TEST_BUILD;

/** `npm start` opens the editor where there is a desktop to open it on; elsewhere the printed address has to do. */
const desktop = process.platform !== 'linux' || Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);

export default defineConfig({
  base: './',
  // Pages, each for itself: an address that there is not is none, and not the editor.
  appType: 'mpa',
  server: { open: desktop && process.env.npm_lifecycle_event === 'start' },
  preview: { open: false },
  plugins: [shaders(), learn(), reference(), site()],
  // zundo asks for all of zustand, which brings React with it; it uses what the plain part has.
  resolve: { alias: [{ find: /^zustand$/, replacement: 'zustand/vanilla' }] },
  worker: { format: 'es' },
  build: {
    target: 'es2023',
    outDir: testBuild ?? 'dist',
    emptyOutDir: true,
    rollupOptions: { input: pages.map((page) => resolve(import.meta.dirname, page)) },
  },
});
