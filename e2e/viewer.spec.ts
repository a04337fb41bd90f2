import { expect, test } from '@playwright/test';

/** The client that people copy beside their page, as this test needs it. */
interface Client {
  viewerIn(frame: HTMLIFrameElement): {
    call(name: string, ...args: unknown[]): Promise<unknown>;
    on(event: string, listener: (detail: unknown) => void): () => void;
  };
}
type Viewer = ReturnType<Client['viewerIn']>;

declare global {
  interface Window {
    told: string[];
    violations: string[];
    showIn(address: string): Promise<Viewer>;
  }
}

// The viewer in a page of another origin, small.
test('a frame in a page of another origin shows a tree or a link of the editor, does what it is told, and keeps to its policy', async ({
  page,
  baseURL,
}) => {
  const viewer = new URL('viewer.html', baseURL);
  const around = new URL('404.html', viewer);
  around.hostname = viewer.hostname === 'localhost' ? '127.0.0.1' : 'localhost';
  const elsewhere: string[] = [];
  page.on('request', (request) => {
    const { protocol, host } = new URL(request.url());
    if (protocol.startsWith('http') && host !== viewer.host && host !== around.host) elsewhere.push(request.url());
  });
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
      parent.postMessage({ violation: `${violatedDirective} ${blockedURI}` }, '*'),
    );
  });
  await page.goto(around.href);
  await page.evaluate(async () => {
    const client = './viewer-client.js';
    const { viewerIn } = (await import(client)) as Client;
    window.told = [];
    window.violations = [];
    addEventListener('message', ({ data }) => {
      if (data?.violation) window.violations.push(data.violation);
    });
    window.showIn = async (address) => {
      const frame = document.createElement('iframe');
      Object.assign(frame, { src: address, title: 'A tree', width: 240, height: 180, loading: 'lazy' });
      document.body.replaceChildren(frame);
      const viewer = viewerIn(frame);
      for (const event of ['ready', 'load', 'error']) viewer.on(event, () => window.told.push(event));
      await new Promise<unknown>((done) => viewer.on('load', done));
      return viewer;
    };
  });

  const found = await page.evaluate(async (address) => {
    const viewer = await window.showIn(address);
    const picture = (await viewer.call('toBlob', { width: 60, height: 40 })) as Blob;
    const drawn = await createImageBitmap(picture);
    const context = new OffscreenCanvas(60, 40).getContext('2d')!;
    context.drawImage(drawn, 0, 0);
    const colours = new Set(new Uint32Array(context.getImageData(0, 0, 60, 40).data.buffer));
    await viewer.call('seek', 3);
    await viewer.call('set', { season: 'autumn', 'wind-speed': '9m/s' });
    const wrong = await viewer.call('set', { onclick: 'alert(1)' }).catch((error: Error) => error.message);
    const { time, season, windSpeed, seed, paused } = (await viewer.call('getState')) as Record<string, unknown>;
    return { state: { time, season, windSpeed, seed, paused }, wrong, colours: colours.size, told: window.told };
  }, `${viewer.href}?species=dead-tree&seed=3&wind=breeze&paused&detail=low&shadow=off`);
  expect(found.state).toEqual({ time: 3, season: 'autumn', windSpeed: 9, seed: 3, paused: true });
  expect(found.wrong).toContain('There is no attribute onclick');
  expect(found.colours).toBeGreaterThan(20);
  expect(found.told).toEqual(['ready', 'load']);

  // What the editor's snippet holds: the link as it is.
  const linked = await page.evaluate(async (address) => {
    const viewer = await window.showIn(address);
    return (await viewer.call('getState')) as Record<string, unknown>;
  }, `${viewer.href}#s=dead-tree&seed=7&tree.scale=9&t=2&paused=1&cam=40,12,20,0,4,0&season=winter&stage=golden&wind=gale&hour=17.5&levels=2&view=levels&probe=3`);
  expect(linked).toMatchObject({
    seed: 7,
    time: 2,
    paused: true,
    season: 'winter',
    environment: 'golden',
    hour: 17.5,
    levels: 2,
    debug: 'levels',
    camera: { azimuth: 40, elevation: 12, distance: 20, target: [0, 4, 0] },
  });
  const frame = page.frameLocator('iframe');
  await expect(frame.locator('canvas')).toBeVisible();
  await expect(frame.getByRole('link', { name: 'Windgrove' })).toHaveAttribute(
    'href',
    /index\.html#s=dead-tree&seed=7/,
  );
  expect(await page.evaluate(() => window.violations)).toEqual([]);
  expect(elsewhere).toEqual([]);
});
