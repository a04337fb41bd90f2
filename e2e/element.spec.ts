import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { expect, type Page, test } from '@playwright/test';

// The element by itself, on a page with a strict Content-Security-Policy: e2e/pages/element.ts.
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Opens the page with contexts and workers counted; without WebGL2 where asked. */
async function open(page: Page, { webgl = true, workers = true } = {}): Promise<string[]> {
  const faults: string[] = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => {
    if (/Content.Security|violates|Refused/i.test(message.text())) faults.push(message.text());
  });
  await page.addInitScript(
    ([webgl, workers]) => {
      const made = { contexts: 0, workers: 0, living: 0 };
      Object.assign(window, { made });
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
        if (kind.startsWith('webgl')) {
          if (!webgl) return null;
          made.contexts++;
        }
        return Reflect.apply(getContext, this, [kind, ...rest]);
      } as typeof getContext;
      window.Worker = class extends Worker {
        constructor(url: string | URL, options?: WorkerOptions) {
          if (!workers) throw new DOMException('no workers here', 'SecurityError');
          super(url, options);
          made.workers++;
          made.living++;
        }
        override terminate(): void {
          made.living--;
          super.terminate();
        }
      };
    },
    [webgl, workers] as const,
  );
  await page.goto('e2e/pages/element.html');
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
  return faults;
}

test('shows a tree from poster to picture, is turned by keys, held still, survives bad attributes and a lost context', async ({
  page,
}) => {
  const faults = await open(page);
  const first = await page.evaluate(async () => {
    const { add, next, colours } = window.elements;
    const tree = add(
      { id: 'a', species: 'quaking-aspen', time: '1s', 'camera-controls': '', alt: 'An aspen' },
      'poster',
    );
    await tree.updateComplete;
    const poster = getComputedStyle(tree.shadowRoot!.querySelector('.poster')!).visibility;
    const load = await next(tree, 'load');
    await tree.updateComplete;
    const status = tree.shadowRoot!.querySelector('[role=status]')!.textContent;
    const gone = tree.shadowRoot!.querySelector('.poster')!.classList.contains('gone');
    return {
      poster,
      load,
      gone,
      status,
      colours: colours(tree),
      paused: tree.paused,
      ready: tree.matches(':state(ready)'),
    };
  });
  expect(first).toMatchObject({ poster: 'visible', gone: true, paused: true, ready: true });
  expect(first.load).toMatchObject({ species: 'Quaking Aspen', seed: 1 });
  expect(first.status).toMatch(/^Ready, [\d,]+ triangles\.$/);
  expect(first.colours).toBeGreaterThan(500);

  // Keys: the camera, and time.
  const canvas = page.getByRole('img', { name: 'An aspen' });
  await canvas.focus();
  const turned = page.evaluate(() => window.elements.next(document.querySelector('#a')!, 'camera-change'));
  await page.keyboard.press('ArrowRight');
  expect(await turned).toMatchObject({ source: 'user' });
  const played = page.evaluate(() => window.elements.next(document.querySelector('#a')!, 'timeupdate'));
  await page.getByRole('button', { name: 'Let the wind blow' }).click();
  expect(((await played) as { time: number }).time).toBeGreaterThanOrEqual(1);
  await canvas.focus();
  await page.keyboard.press(' ');
  await expect(page.getByRole('button', { name: 'Let the wind blow' })).toBeVisible();

  // The latest wish wins, a bad value leaves the old one, and what is taken out while it loads is gone.
  const told = await page.evaluate(async () => {
    const { add, next } = window.elements;
    const tree = document.querySelector('#a') as HTMLElementTagNameMap['wind-tree'];
    const seeds: unknown[] = [];
    tree.addEventListener('load', (event) => seeds.push((event as CustomEvent).detail.seed));
    tree.setAttribute('wind-speed', '20km/h');
    await tree.updateComplete;
    const error = next(tree, 'error');
    tree.setAttribute('wind-speed', '6 mph');
    const message = await error;
    // The clock's own time is no attribute's: a text that is none must not stay and make a still of the tree.
    tree.setAttribute('time', 'soon');
    const kept = [Number(tree.windSpeed?.toFixed(3)), tree.getAttribute('wind-speed'), tree.getAttribute('time')];
    const half = next(tree, 'error');
    tree.windData = { name: 'Half', waves: [1], gusts: [] } as never;
    const halfWind = await half;
    tree.windData = null;
    tree.seed = 2;
    await next(tree, 'progress');
    tree.seed = 5;
    await next(tree, 'load');
    const renderer = await window.elements.renderer();
    const users = renderer.users;
    const brief = add({ species: 'apple', loading: 'eager' });
    let loaded = false;
    brief.addEventListener('load', () => {
      loaded = true;
    });
    await next(brief, 'progress');
    brief.remove();
    tree.seed = 7;
    await next(tree, 'load');
    const state = tree.getState();
    const forgotten = add({ species: 'apple', loading: 'eager' });
    await next(forgotten, 'progress');
    const left = next(forgotten, 'statechange') as Promise<{ state: string }>;
    forgotten.removeAttribute('species');
    const forgot = (await left).state;
    forgotten.remove();
    const twin = add({ loading: 'eager' });
    twin.setState(JSON.parse(JSON.stringify(state)));
    await next(twin, 'load');
    const same = JSON.stringify(twin.getState()) === JSON.stringify(state);
    twin.remove();
    return { message, kept, halfWind, seeds, loaded, forgot, users: renderer.users - users, same, state };
  });
  expect(told.message).toMatchObject({
    type: 'attribute',
    message: expect.stringMatching(/wind-speed="6 mph".*"6m\/s"/),
  });
  expect(told.kept).toEqual([5.556, '5.55555556m/s', '1s']);
  expect(told.halfWind).toMatchObject({ type: 'wind', message: expect.stringMatching(/^windData: .*allowed/) });
  expect(told).toMatchObject({ seeds: [5, 7], loaded: false, forgot: 'idle', users: 0, same: true });
  expect(told.state).toMatchObject({ seed: 7, paused: true, camera: { distance: expect.any(Number) } });

  // Far from the window its memory on the GPU is given back, and comes again with the next picture.
  const away = await page.evaluate(async () => {
    const { colours, renderer } = window.elements;
    const tree = document.querySelector('#a') as HTMLElementTagNameMap['wind-tree'];
    const textures = async (): Promise<number> => (await renderer()).info!.textures;
    const before = await textures();
    tree.style.marginTop = '9000px';
    while (tree.tree) await new Promise(requestAnimationFrame);
    const freed = before - (await textures());
    tree.style.marginTop = '0';
    tree.seek(3);
    while (!tree.tree) await new Promise(requestAnimationFrame);
    return { freed, colours: colours(tree) };
  });
  expect(away.freed).toBeGreaterThan(5);
  expect(away.colours).toBeGreaterThan(500);

  // What is loaded when it is asked for: views for those who look inside, what twigs bear in spring, and answers to rays.
  const later = await page.evaluate(async () => {
    const { picture } = window.elements;
    const tree = document.querySelector('#a') as HTMLElementTagNameMap['wind-tree'];
    const first = picture(tree);
    const seen = new Set([first]);
    const until = async (there: () => boolean): Promise<void> => {
      while (!there()) await new Promise(requestAnimationFrame);
    };
    for (const debug of ['state', 'field', 'skeleton'] as const) {
      tree.debug = debug;
      await until(() => !seen.has(picture(tree)));
      seen.add(picture(tree));
    }
    tree.debug = 'none';
    await until(() => picture(tree) === first);
    const { triangles } = tree.stats;
    tree.season = 'spring';
    await until(() => tree.stats.triangles !== triangles);
    tree.season = 'summer';
    await until(() => tree.stats.triangles === triangles);
    return { hour: tree.hour, capable: tree.capabilities?.degradation };
  });
  expect(later).toEqual({ hour: null, capable: 'none' });

  // The context goes and comes back: the picture stands meanwhile, and goes on.
  const lost = await page.evaluate(async () => {
    const { next, picture, colours, renderer } = window.elements;
    const tree = document.querySelector('#a') as HTMLElementTagNameMap['wind-tree'];
    const shared = await renderer();
    const gl = shared.canvas!.getContext('webgl2')!;
    const extension = gl.getExtension('WEBGL_lose_context')!;
    const error = next(tree, 'error');
    extension.loseContext();
    const detail = await error;
    const before = picture(tree);
    const stands = colours(tree);
    const back = new Promise((done) => shared.canvas!.addEventListener('webglcontextrestored', done, { once: true }));
    // Not before the event has been heard by all.
    await new Promise(requestAnimationFrame);
    extension.restoreContext();
    await back;
    tree.seek(9);
    while (picture(tree) === before) await new Promise(requestAnimationFrame);
    return { detail, stands, after: colours(tree) };
  });
  expect(lost.detail).toMatchObject({ type: 'contextlost' });
  for (const colours of [lost.stands, lost.after]) expect(colours).toBeGreaterThan(500);

  expect(faults).toEqual([]);
  // As the console would: the page's policy lets no script in that is not its own.
  await page.evaluate(axe);
  const found = await page.evaluate(async () => {
    const { axe } = window as unknown as {
      axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> };
    };
    return (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' | ')}`);
  });
  expect(found).toEqual([]);
});

test('gives twenty elements one context and one worker, and loses nothing in 200 that come and go', async ({
  page,
}) => {
  await open(page);
  const cdp = await page.context().newCDPSession(page);
  /** Bytes that scripts hold, arrays that lie beside the heap included. */
  const held = async (): Promise<number> => {
    await cdp.send('HeapProfiler.collectGarbage');
    const usage: { usedSize: number; backingStorageSize?: number } = await cdp.send('Runtime.getHeapUsage');
    return usage.usedSize + (usage.backingStorageSize ?? 0);
  };
  const style = { species: 'quaking-aspen', time: '0s', loading: 'eager', 'max-pixel-ratio': '0.25', detail: 'low' };
  const counts = () =>
    page.evaluate(async () => {
      const { renderer, place } = window.elements;
      const { info, users } = await renderer();
      return { ...info, users, nodes: document.querySelectorAll('*').length, left: place.children.length };
    });

  const twenty = await page.evaluate(async (style) => {
    const { add, next, renderer } = window.elements;
    const trees = Array.from({ length: 20 }, (_, i) => add({ ...style, seed: String(i) }));
    await Promise.all(trees.map((tree) => next(tree, 'load')));
    const seen = { ...window.made, users: (await renderer()).users };
    for (const tree of trees.slice(1)) tree.remove();
    return seen;
  }, style);
  expect(twenty).toEqual({ contexts: 1, workers: 1, living: 1, users: 20 });

  const [before, heldBefore] = [await counts(), await held()];
  await page.evaluate(async (style) => {
    const { add, next } = window.elements;
    for (let i = 0; i < 200; i++) {
      const tree = add({ ...style, seed: '1' });
      // Most go while they load, some before anything, some with a picture.
      if (i % 50 === 0) await next(tree, 'load');
      else if (i % 4 === 0) await next(tree, 'progress');
      tree.remove();
    }
    const last = add({ ...style, seed: '1' });
    await next(last, 'load');
    last.remove();
  }, style);
  expect(await counts()).toEqual(before);
  expect(before).toMatchObject({ users: 1, left: 1 });
  // The elements alone, were they kept without their trees, would be 0.8 MB more; what the engine itself keeps is 0.4 MB.
  expect((await held()) - heldBefore).toBeLessThan(7e5);
  // A worker that grows what nobody wants any more is replaced: there is one, and at most one more that begins.
  const made = await page.evaluate(() => window.made);
  expect(made.contexts).toBe(1);
  expect(made.living).toBeLessThanOrEqual(2);
});

test('does without workers; without WebGL2 it says so, and shows the slot for it', async ({ page }) => {
  await open(page, { workers: false });
  const here = await page.evaluate(async () => {
    const { add, next, colours } = window.elements;
    const tree = add({ species: 'quaking-aspen', autoplay: 'off' });
    await next(tree, 'load');
    return { colours: colours(tree), paused: tree.paused, workers: window.made.workers };
  });
  expect(here).toMatchObject({ paused: true, workers: 0 });
  expect(here.colours).toBeGreaterThan(500);

  const faults = await open(page, { webgl: false });
  const lack = await page.evaluate(async () => {
    const { add, next } = window.elements;
    const tree = add({ species: 'quaking-aspen' }, 'fallback');
    const detail = await next(tree, 'error');
    await tree.updateComplete;
    const shown = (tree.children[0] as HTMLElement).getBoundingClientRect().height > 0;
    return { detail, shown, error: tree.matches(':state(error)'), workers: window.made.workers };
  });
  expect(lack).toMatchObject({ detail: { type: 'capability' }, shown: true, error: true, workers: 0 });
  await expect(page.getByText('In the slot fallback')).toBeVisible();
  expect(faults).toEqual([]);
});
