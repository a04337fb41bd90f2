import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';

/** Pages that ship; each is an entry of the build. */
const pages = ['index.html', 'crosscheck.html'];

export default defineConfig({
  base: './',
  plugins: [glsl({ root: '/shaders/' })],
  worker: { format: 'es' },
  build: {
    target: 'es2023',
    rollupOptions: { input: pages.map((page) => resolve(import.meta.dirname, page)) },
  },
});
