import { expect, test } from '@playwright/test';
import type { ForestInvariants } from './pages/forest-invariants.ts';

declare global {
  interface Window {
    forestInvariants: ForestInvariants;
  }
}

let complaints: string[] = [];

test.beforeEach(async ({ page }) => {
  complaints = [];
  // A program that does not compile draws nothing, and the picture still looks like one.
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  await page.goto('/e2e/pages/forest-invariants.html');
  await page.locator('body[data-ready=true]').waitFor();
});

test.afterEach(() => expect(complaints).toEqual([]));

test('whoever enters and leaves a forest over and over leaves nothing behind', async ({ page }) => {
  const { first, last, drawn } = await page.evaluate(() => window.forestInvariants.comeAndGo(50));
  expect(last).toEqual(first);
  // Something was there to be left behind: all trees, near and as cards.
  expect(drawn.near + drawn.middle).toBe(12);
  expect(drawn.groves).toBeGreaterThan(3);
});

test('no flight jumps where trees change their class, and a hillside of 300 trees stays small', async ({ page }) => {
  for (const entered of ['near', 'middle'] as const) {
    const { steps, seen } = await page.evaluate((entered) => window.forestInvariants.flight(24, entered, 1), entered);
    const median = steps.toSorted((a, b) => a - b)[steps.length / 2]!;
    expect(median).toBeGreaterThan(0.1);
    // A hard switch is four medians (crossFade 0).
    expect(Math.max(...steps)).toBeLessThan(2 * median);
    expect(seen.at(-1)?.[entered]).toBeGreaterThan(6);
  }
  const { stats, calls } = await page.evaluate(() => window.forestInvariants.hillside());
  expect(stats.trees).toBe(300);
  expect([stats.near, stats.middle, stats.far].every((count) => count > 10)).toBe(true);
  expect(stats.drawCalls).toBeLessThan(120);
  expect(calls).toBeLessThan(240);
  expect(stats.bytes).toBeLessThan(12 * 2 ** 20);
});
