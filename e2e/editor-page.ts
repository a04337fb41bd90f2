import { expect, type Page } from '@playwright/test';
import type { TestHook } from '../src/editor/test-hook.ts';

declare global {
  interface Window {
    windgrove?: TestHook;
  }
}

/** A tree that is drawn fast: the aspen's trunk and limbs without leaves, standing still. */
export const BARE = 'seed=3&t=2&paused=1&levels=2&leaves=0';

/** Opens the editor with a link and waits until the tree that it asks for is drawn; returns what the page complained of. */
export async function open(page: Page, link: string): Promise<string[]> {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  await page.goto(`./#${link}`);
  await ready(page);
  return complaints;
}

/** Waits until the wished tree is on the screen. */
export const ready = (page: Page): Promise<void> =>
  expect(page.locator('html')).toHaveAttribute('data-ready', 'true', { timeout: 60_000 });

/** Waits until nothing is left to draw; only while time stands. */
export const settled = (page: Page): Promise<void> => page.evaluate(() => window.windgrove!.settled());

export const state = (page: Page) => page.evaluate(() => window.windgrove!.state());

/** Runs a check in the light theme and in the dark one, once nothing fades any more; the page must follow the system. */
export async function inBothThemes(page: Page, check: (theme: string) => Promise<void>): Promise<void> {
  const themes = ['light', 'dark'] as const;
  // The one that there is comes first: with each change the meadow has another time of day.
  const dark = (await page.locator('html').getAttribute('data-theme')) === 'dark';
  for (const theme of dark ? themes.toReversed() : themes) {
    await page.emulateMedia({ colorScheme: theme });
    await expect(page.locator('html')).toHaveAttribute('data-theme', theme);
    await page.evaluate(() => Promise.allSettled(document.getAnimations().map((a) => a.finished)));
    await check(theme);
  }
}

/** Tips of all pieces as drawn, 3 a piece. */
export const tips = (page: Page): Promise<number[]> => page.evaluate(() => window.windgrove!.tips());

/** The picture without the interface, a PNG as a data: address. */
export const picture = (page: Page): Promise<string> => page.evaluate(() => window.windgrove!.picture());

/** The values of the address once it holds what `wanted` says: it is written a little after the picture. */
export async function address(page: Page, wanted: RegExp): Promise<URLSearchParams> {
  await expect(page).toHaveURL(wanted);
  return new URLSearchParams(new URL(page.url()).hash.slice(1));
}

/** Pixels in which two pictures of the same size differ by more than `most` (0..255) in green, or at all, as x, y pairs; and how many colours the first has. */
export function difference(
  page: Page,
  a: string,
  b: string,
  most: number | null = null,
): Promise<{ pixels: number[]; colours: number }> {
  return page.evaluate(
    async ([a, b, most]) => {
      const read = async (url: string): Promise<ImageData> => {
        const image = await createImageBitmap(await (await fetch(url)).blob());
        const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      };
      const [one, other] = await Promise.all([read(a), read(b)]);
      const left = new Uint32Array(one.data.buffer);
      const right = new Uint32Array(other.data.buffer);
      const pixels: number[] = [];
      for (let i = 0; i < left.length; i++) {
        const differs =
          most === null ? left[i] !== right[i] : Math.abs(one.data[4 * i + 1]! - other.data[4 * i + 1]!) > most;
        if (differs) pixels.push(i % one.width, Math.floor(i / one.width));
      }
      return { pixels, colours: new Set(left).size };
    },
    [a, b, most] as const,
  );
}
