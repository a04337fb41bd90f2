// The browser and the server that the pictures of docs/ are taken with: the tests' browser, so that anybody gets the same pictures.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, chromium, type Page } from '@playwright/test';
import { createServer } from 'vite';
import { browserArgs, findBrowser } from '../e2e/browser.mjs';

/** Folder of the pictures. */
export const docs = import.meta.dirname;

/** Serves the repository, opens a page of `width` x `height` pixels, hands both to `work`, and closes everything after it. */
export async function withPage(
  size: { width: number; height: number },
  work: (page: Page, address: string, browser: Browser) => Promise<void>,
): Promise<void> {
  const server = await createServer({
    root: join(docs, '..'),
    logLevel: 'warn',
    server: { host: '127.0.0.1', open: false, hmr: false, watch: null },
  });
  await server.listen();
  const { port } = server.httpServer!.address() as { port: number };
  const { executablePath } = await findBrowser();
  const browser = await chromium.launch({ executablePath, args: browserArgs });
  try {
    const page = await browser.newPage({ viewport: size, deviceScaleFactor: 1, colorScheme: 'light' });
    page.on('pageerror', (error) => console.error(error.message));
    page.on('console', (message) => message.type() === 'error' && console.error(message.text()));
    await work(page, `http://127.0.0.1:${port}/`, browser);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** A screenshot (PNG) as an opaque WebP picture: the browser encodes it. `quality` 0 to 1. */
export async function webpOf(page: Page, png: Buffer, quality: number): Promise<Uint8Array> {
  const text = await page.evaluate(
    async ([data, q]) => {
      const bitmap = await createImageBitmap(await (await fetch(data)).blob());
      const canvas = document.createElement('canvas');
      canvas.width = bitmap.width;
      canvas.height = bitmap.height;
      canvas.getContext('2d', { alpha: false })!.drawImage(bitmap, 0, 0);
      return canvas.toDataURL('image/webp', q);
    },
    [`data:image/png;base64,${png.toString('base64')}`, quality] as const,
  );
  return new Uint8Array(Buffer.from(text.split(',')[1]!, 'base64'));
}

/** Writes a picture into docs/ and says how large it is. */
export function save(name: string, bytes: Uint8Array): void {
  writeFileSync(join(docs, name), bytes);
  console.log(`docs/${name}: ${Math.round(bytes.length / 1024)} kB`);
}
