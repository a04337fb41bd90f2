import { defineConfig } from 'vitest/config';
import { shaders } from './build/glsl.ts';

// Apart from vite.config.ts: tests need the shaders as text, not the pages or the build.
export default defineConfig({
  plugins: [shaders()],
  // As in vite.config.ts: zundo does without React.
  resolve: { alias: [{ find: /^zustand$/, replacement: 'zustand/vanilla' }] },
  test: {
    server: { deps: { inline: ['zundo'] } },
    environment: 'node',
    include: ['tests/**/*.test.ts'],
    setupFiles: ['tests/random-seed.ts'],
    // Long enough for the slowest tree on a busy machine of two cores; a test that needs longer is too large.
    testTimeout: 60_000,
    hookTimeout: 60_000,
    retry: 0,
    // By itself it leaves one core alone, which is half of a machine of two.
    maxWorkers: '100%',
  },
});
