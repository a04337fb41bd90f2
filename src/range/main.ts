import { oneLine } from '../core/file/one-line.ts';
import { loadSpecies, loadWind } from '../view/load.ts';
import type { DrawnElements } from '../view/wind-tree.ts';
import { RangePage } from './page.ts';
import { type Figures, RangePicture } from './picture.ts';
import { type RangeState, readState, writeState } from './state.ts';
import { rangeWords as words } from './words.ts';

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;

/** Lines that the message about a link has at most. */
const LISTED = 6;

let state: RangeState;
let notice: readonly string[] = [];

/** Takes the address as it is typed. */
function readAddress(): void {
  const { state: read, faults } = readState(location.search);
  state = still ? { ...read, wind: false } : read;
  notice = faults
    .slice(0, LISTED)
    .map(({ key, found, allowed }) => words.fault(oneLine(key), oneLine(found, 60), allowed));
}
readAddress();

let picture: RangePicture | null = null;
let table: readonly DrawnElements[] = [];
let figures: Figures | null = null;
let milliseconds = 0;
let time = 3;
let settled = 0;

const dark = (): boolean => state.dark ?? system.matches;

const dismiss = (): void => {
  notice = [];
  refresh();
};

const page = new RangePage(document.querySelector('#page') as HTMLElement, dismiss, (change) => {
  state = { ...state, ...change };
  history.replaceState(null, '', `${location.pathname}${writeState(state)}`);
  settled = 0;
  delete root.dataset.ready;
  refresh();
  wake();
});

function refresh(): void {
  root.dataset.theme = dark() ? 'dark' : 'light';
  show(milliseconds);
}

const show = (milliseconds: number): void => page.show({ state, dark: dark(), notice, table, figures, milliseconds });

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
    if (settled < 4) show(settled < 2 ? 0 : milliseconds);
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
  readAddress();
  refresh();
  wake();
});
begin().catch((error: unknown) => page.fail(words.failed(error instanceof Error ? error.message : String(error))));
