import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import glsl from 'vite-plugin-glsl';

/** Pages that ship; each is an entry of the build. */
const pages = ['index.html', 'crosscheck.html'];

/** `npm start` opens the editor where there is a desktop to open it on; elsewhere the printed address has to do. */
const desktop = process.platform !== 'linux' || Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);

export default defineConfig({
  base: './',
  server: { open: desktop && process.env.npm_lifecycle_event === 'start' },
  preview: { open: false },
  plugins: [glsl({ root: '/shaders/' })],
  worker: { format: 'es' },
  build: {
    target: 'es2023',
    rollupOptions: { input: pages.map((page) => resolve(import.meta.dirname, page)) },
  },
});
