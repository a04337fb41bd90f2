import type { ForestCamera, ForestDocument } from '../core/forest/forest.ts';
import type { ForestStats } from '../view/forest/forest.ts';
import type { Store } from './store.ts';
import type { World } from './world.ts';

/** What tests and curious people may ask the page for: `window.windgroveForest`. */
export interface ForestHook {
  /** What the link holds, but for the camera. */
  state(): ForestDocument;
  camera(): ForestCamera;
  stats(): ForestStats;
  /** Seconds of the clock. */
  time(): number;
  seek(seconds: number): void;
  /** Nothing is growing, fading or being photographed. */
  settled(): boolean;
}

declare global {
  interface Window {
    windgroveForest?: ForestHook;
  }
}

/** Hangs the hook on the window. */
export function installTestHook(store: Store, world: World): void {
  window.windgroveForest = {
    state: () => store.state.document,
    camera: () => ({ ...world.flight.eye }),
    stats: () => world.stats,
    time: () => world.clock.time,
    seek: (seconds) => world.clock.seek(seconds),
    settled: () => !world.busy,
  };
}
