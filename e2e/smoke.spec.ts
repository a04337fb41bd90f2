import { expect, type Page, test } from '@playwright/test';
import { difference, open, picture } from './editor-page.ts';

/** What a page said that no page should say: errors of its scripts, of its console, of its requests. */
function complaintsOf(page: Page): string[] {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(`error: ${error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`console: ${message.text()}`);
  });
  page.on('requestfailed', (request) => complaints.push(`request: ${request.url()}`));
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`status ${response.status()}: ${response.url()}`);
  });
  return complaints;
}

// The whole aspen in the wind, drawn in software: a small window is enough to see that it is there.
test.use({ viewport: { width: 480, height: 360 } });

test('the browser has WebGL2 and draws with the software renderer that golden pictures are made with', async ({
  page,
}) => {
  await page.goto('about:blank');
  const renderer = await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const names = gl?.getExtension('WEBGL_debug_renderer_info');
    return gl && names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : 'none';
  });
  expect(renderer).toContain('SwiftShader');
});

test('a newcomer, with no link, gets a picture of a tree', async ({ page }) => {
  await open(page, '');
  await expect(page.locator('canvas').first()).toBeVisible();
  const drawn = await picture(page);
  const { colours } = await difference(page, drawn, drawn);
  expect(colours).toBeGreaterThan(1000);
});

for (const [name, path] of [
  ['editor', './'],
  ['cross-check', './crosscheck.html'],
] as const) {
  test(`the ${name} loads without complaint and asks no other host for anything`, async ({ page, baseURL }) => {
    const complaints = complaintsOf(page);
    const foreign: string[] = [];
    page.on('request', (request) => {
      const url = request.url();
      if (!url.startsWith(baseURL!) && !/^(data|blob):/.test(url)) foreign.push(url);
    });
    await page.goto(path, { waitUntil: 'networkidle' });
    await expect(page).toHaveTitle(/Windgrove/);
    expect(complaints).toEqual([]);
    expect(foreign).toEqual([]);
  });
}
