import { loadSpecies, loadWind } from '../view/load.ts';
import type { DrawnElements } from '../view/wind-tree.ts';
import { RangePage } from './page.ts';
import { type Figures, RangePicture } from './picture.ts';
import { readState, writeState } from './state.ts';
import { rangeWords as words } from './words.ts';

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;

let state = readState(location.search);
if (still) state = { ...state, wind: false };
let picture: RangePicture | null = null;
let table: readonly DrawnElements[] = [];
let figures: Figures | null = null;
let milliseconds = 0;
let time = 3;
let settled = 0;

const dark = (): boolean => state.dark ?? system.matches;

const page = new RangePage(document.querySelector('#page') as HTMLElement, (change) => {
  state = { ...state, ...change };
  history.replaceState(null, '', `${location.pathname}${writeState(state)}`);
  settled = 0;
  delete root.dataset.ready;
  refresh();
  wake();
});

function refresh(): void {
  root.dataset.theme = dark() ? 'dark' : 'light';
  page.show({ state, dark: dark(), table, figures, milliseconds });
}

let waiting = 0;
let last = 0;

/** Sees to it that a frame is drawn; where a frame takes long, the page keeps half of the time for itself. */
function wake(): void {
  if (waiting || document.hidden) return;
  waiting = requestAnimationFrame((now) => {
    waiting = 0;
    if (!picture) return;
    if (state.wind && last > 0) time += Math.min(0.1, (now - last) / 1000);
    last = state.wind ? now : 0;
    // The first frame of a new state is waited for, so that no queue grows before the GPU; the third is timed well.
    if (settled === 0) milliseconds = picture.measure(state, dark(), time, 1);
    else if (settled === 2) milliseconds = picture.measure(state, dark(), time, 3);
    else picture.draw(state, dark(), time);
    figures = picture.figures();
    if (settled < 4) page.show({ state, dark: dark(), table, figures, milliseconds: settled < 2 ? 0 : milliseconds });
    if (settled === 3) root.dataset.ready = 'true';
    settled = Math.min(settled + 1, 4);
    if (settled < 4 || state.wind || picture.stage.moving) {
      // Where a frame takes long the page keeps as much time for itself.
      if (milliseconds > 30) setTimeout(wake, 1.5 * milliseconds);
      else wake();
    }
  });
}

async function begin(): Promise<void> {
  refresh();
  const [species, wind] = await Promise.all([loadSpecies('species/quaking-aspen.json'), loadWind('winds/breeze.json')]);
  picture = new RangePicture(page.canvas, page.inset, species, wind, state.seed);
  table = await picture.countTable();
  page.ready();
  refresh();
  new ResizeObserver(() => {
    picture?.resize();
    wake();
  }).observe(page.canvas);
  picture.stage.controls.addEventListener('change', wake);
  wake();
}

system.addEventListener('change', () => {
  refresh();
  wake();
});
document.addEventListener('visibilitychange', wake);
addEventListener('popstate', () => {
  state = readState(location.search);
  refresh();
  wake();
});
begin().catch((error: unknown) => page.fail(words.failed(error instanceof Error ? error.message : String(error))));
