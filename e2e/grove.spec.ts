import { expect, test } from '@playwright/test';

test('a grove looks like its trees, fades by classes that add up to it, in its shadow too, and leaves nothing', async ({
  page,
}) => {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('ReadPixels'))
      complaints.push(message.text());
  });
  await page.goto('e2e/pages/grove.html');
  await page.waitForFunction(() => 'grove' in window);
  const seen = await page.evaluate(() => window.grove);
  expect(complaints).toEqual([]);
  expect(seen.trees).toBeGreaterThan(0.06);
  expect(seen.shadow).toBeGreaterThan(0.01);
  expect(seen['grove against trees']).toBeLessThan(0.03);
  expect(seen['half of it against all']).toBeGreaterThan(0.03);
  expect(seen['half its shadow against all']).toBeGreaterThan(0.005);
  expect(seen['both halves against all']).toBeLessThan(0.01);
  expect(seen['none of it against the meadow']).toBe(0);
  expect(seen.calls.alone).toBe(3 * seen.calls.together);
  expect(seen.leaks).toEqual([0, 0]);
});
