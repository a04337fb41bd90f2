import type { ForestDocument } from '../core/forest/forest.ts';
import { addressOf, readAddress } from './address.ts';
import { takeMap } from './panel-ground.ts';
import { drawCounters, drawFailure, drawShell } from './shell.ts';
import { type Scene, Sources } from './sources.ts';
import { type Notice, Store } from './store.ts';
import { installTestHook } from './test-hook.ts';
import { followSystemTheme } from './theme.ts';
import { words } from './words.ts';
import { World } from './world.ts';

/** Milliseconds between two readings of the counters, and from the last change to the address. */
const COUNTERS = 400;
const ADDRESS = 500;

/** Pixels of a window that is too narrow for the panel beside the picture. */
const NARROW = '(max-width: 700px)';

const textOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Starts the page: the picture in `picture`, all else in `over`. */
export async function boot(picture: HTMLElement, over: HTMLElement): Promise<void> {
  let setDark: (dark: boolean) => void = () => {};
  followSystemTheme((dark) => setDark(dark));
  if (!document.createElement('canvas').getContext('webgl2')) {
    drawFailure(over, words.noWebGl, words.noWebGlMore);
    return;
  }
  const canvas = picture.appendChild(document.createElement('canvas'));
  canvas.tabIndex = 0;
  canvas.setAttribute('aria-label', words.picture);
  canvas.setAttribute('role', 'application');
  try {
    const sources = await Sources.load();
    const world = new World(canvas, sources);
    setDark = (dark) => world.setDark(dark);
    setDark(document.documentElement.dataset.theme === 'dark');
    run(picture, over, sources, world);
  } catch (error) {
    drawFailure(over, words.broken, textOf(error));
  }
}

function run(picture: HTMLElement, over: HTMLElement, sources: Sources, world: World): void {
  const first = sources.scenes[0]!.document;
  const read = readAddress(sources, first);
  const store = new Store({
    document: read?.document ?? first,
    notice: read?.notice ?? null,
    playing: !matchMedia('(prefers-reduced-motion: reduce)').matches,
    open: !matchMedia(NARROW).matches,
  });
  /** The next change brings the document's camera with it. */
  let jump = true;
  let written = '';
  let asked = 0;
  /** What was last said about trees without a place. */
  let room: Notice | null = null;
  const write = (): void => {
    asked = 0;
    written = addressOf(store.state.document, world.flight.eye);
    history.replaceState(null, '', written);
  };
  const writeSoon = (): void => {
    clearTimeout(asked);
    asked = window.setTimeout(write, ADDRESS);
  };
  const show = (document: ForestDocument): void => {
    jump = true;
    store.set({ document, heightMap: null, densityMap: null });
  };
  const onScene = (scene: Scene): void => {
    store.set({ notice: null });
    show(scene.document);
  };
  const onCopy = (): void => {
    write();
    const copied = navigator.clipboard?.writeText(written) ?? Promise.reject(new Error());
    copied.then(
      () => {
        const { terrain, density } = store.state.document;
        const lines = terrain.kind === 'map' || density.kind === 'map' ? [words.lacks] : [];
        store.set({ notice: { kind: 'note', title: words.copied, lines } });
      },
      () => store.set({ notice: { kind: 'note', title: words.notCopied, lines: [] } }),
    );
  };
  /** Escape takes away what lies over the picture: a message first, then the sheet of settings of a narrow window. */
  const leave = (): void => {
    if (store.state.notice) store.set({ notice: null });
    else if (matchMedia(NARROW).matches && store.state.open) {
      store.set({ open: false });
      over.querySelector<HTMLElement>('[data-do=open]')?.focus();
    }
  };
  const draw = (): void => drawShell(over, store, sources, world, { onScene, onCopy });

  world.onForest = (document, standing) => {
    const told = store.state.notice;
    if (standing < document.count) {
      const title = words.noRoom(document.count, standing);
      room = { kind: standing === 0 ? 'error' : 'note', title, lines: [] };
      store.set({ notice: room });
    } else if (told !== null && told === room) store.set({ notice: null });
    else draw();
  };
  world.onError = (error) => store.set({ notice: { kind: 'error', title: words.broken, lines: [textOf(error)] } });
  store.listen((state, before) => {
    draw();
    if (state.document === before.document && state.playing === before.playing && !jump) return;
    world.follow(state, jump);
    jump = false;
    writeSoon();
  });

  new ResizeObserver(() => world.resize(picture.clientWidth, picture.clientHeight)).observe(picture);
  window.addEventListener('hashchange', () => {
    if (location.href === written) return;
    const typed = readAddress(sources, first);
    if (!typed) return;
    store.set({ notice: typed.notice });
    show(typed.document);
  });
  window.addEventListener('keydown', (event) => {
    const { target } = event;
    if (event.code === 'Escape') return leave();
    const busy =
      target instanceof HTMLElement && target.closest('button, input, select, textarea, summary, a') !== null;
    if (event.code !== 'Space' || busy || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    store.set({ playing: !store.state.playing });
  });
  const hold = (dragging: boolean): void => {
    if (dragging !== store.state.dragging) store.set({ dragging });
  };
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) hold(false);
  });
  for (const kind of ['dragover', 'drop'] as const) {
    window.addEventListener(kind, (event) => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      hold(kind === 'dragover');
      const aim = event.target instanceof Element ? event.target.closest<HTMLElement>('[data-map]') : null;
      for (const place of over.querySelectorAll('.drop > [data-map]')) place.toggleAttribute('data-aim', place === aim);
      if (kind === 'dragover') return;
      void takeMap(store, aim?.dataset.map === 'density' ? 'density' : 'height', event.dataTransfer.files[0]);
    });
  }
  world.stage.renderer.domElement.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    store.set({ notice: { kind: 'error', title: words.lost, lines: [] } });
  });

  installTestHook(store, world);
  world.resize(picture.clientWidth, picture.clientHeight);
  world.follow(store.state, true);
  jump = false;
  draw();
  // On a phone the settings are a sheet over the lower part of the picture.
  const panel = over.querySelector<HTMLElement>('.panel')!;
  const sheet = (): number => (matchMedia(NARROW).matches && store.state.open ? panel.offsetHeight : 0);
  new ResizeObserver(() => world.cover(sheet())).observe(panel);
  let counted = 0;
  let seen = '';
  const frame = (now: number): void => {
    requestAnimationFrame(frame);
    world.frame(now);
    const eye = Object.values(world.flight.eye).join();
    if (world.seeded && eye !== seen) writeSoon();
    seen = eye;
    if (now - counted > COUNTERS) {
      counted = now;
      drawCounters(over, world);
    }
    if (!world.busy) document.documentElement.dataset.ready = 'true';
  };
  requestAnimationFrame(frame);
}
