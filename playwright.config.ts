import { createServer } from 'node:net';
import { join } from 'node:path';
import { defineConfig } from '@playwright/test';
import { browserArgs, findBrowser } from './e2e/browser.mjs';

/** A port that is free now: a server left by somebody else is never tested by mistake. */
async function freePort(): Promise<number> {
  return new Promise((done, fail) => {
    const server = createServer();
    server.on('error', fail);
    server.listen(0, '127.0.0.1', () => {
      const address = server.address();
      server.close(() => (address && typeof address === 'object' ? done(address.port) : fail(new Error('no port'))));
    });
  });
}

// Every worker reads this file again: what the first reading found travels to them in the environment.
process.env.WINDGROVE_BROWSER ??= (await findBrowser()).executablePath;
const given = process.env.WINDGROVE_URL;
if (!given) process.env.WINDGROVE_TEST_PORT ??= String(await freePort());
const port = process.env.WINDGROVE_TEST_PORT;
/** Two runs at a time do not build over each other; e2e/clean-up.ts removes it. */
if (!given) process.env.WINDGROVE_TEST_BUILD ??= join(import.meta.dirname, `node_modules/.cache/tested-build-${port}`);

export default defineConfig({
  testDir: 'e2e',
  testMatch: '**/*.spec.ts',
  globalTeardown: './e2e/clean-up.ts',
  outputDir: 'test-results',
  // Software GL compiles a page's shaders on one thread, which is most of what a page costs: two browsers keep two cores busy. No more
  // where there are more cores: each picture is drawn by all of them.
  workers: 2,
  retries: 0,
  forbidOnly: Boolean(process.env.CI),
  // So long that only what hangs ends so, on a slow machine too: the dearest test takes half a minute where nothing else runs.
  timeout: 240_000,
  globalTimeout: 25 * 60_000,
  expect: { timeout: 60_000 },
  reporter: 'list',
  use: {
    baseURL: given ?? `http://127.0.0.1:${port}/`,
    browserName: 'chromium',
    launchOptions: { executablePath: process.env.WINDGROVE_BROWSER, args: browserArgs },
    viewport: { width: 1024, height: 640 },
    deviceScaleFactor: 1,
    locale: 'en-GB',
    timezoneId: 'UTC',
    colorScheme: 'light',
    // What a page shows must not depend on what an earlier one had kept; e2e/site.spec.ts allows it for itself.
    serviceWorkers: 'block',
    trace: 'off',
    screenshot: 'only-on-failure',
  },
  // The build that ships is what is tested: `vite preview` serves files and transforms nothing, so pages load fast and no
  // request waits for a compiler. WINDGROVE_URL tests a server that runs already (`npm start`) while developing.
  webServer: given
    ? undefined
    : {
        command: `npm run build && npx vite build --config vite.pages.config.ts && npm run preview -- --host 127.0.0.1 --port ${port} --strictPort`,
        url: `http://127.0.0.1:${port}/`,
        reuseExistingServer: false,
        timeout: 180_000,
        stdout: 'pipe',
        stderr: 'pipe',
      },
});
