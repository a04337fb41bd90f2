import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { listenToHolds } from '../../src/editor/hold-controls.ts';

/** What stands for the slider: a target that is one of those that are dragged. */
class Slider extends EventTarget {
  closest(): this {
    return this;
  }
}

let stop: () => void;
let heard: string[];
beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('Element', Slider);
  vi.stubGlobal('window', new Slider());
  heard = [];
  const hear = (what: string) => () => void heard.push(what);
  stop = listenToHolds({ hold: hear('hold'), release: hear('release'), holdKey: hear('key') });
});
afterEach(() => {
  stop();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});
const happens = (type: string): boolean => window.dispatchEvent(new Event(type));

describe('what is held', () => {
  it('is let go before the next key is heard, however late timers are', () => {
    happens('pointerdown');
    happens('pointerup');
    heard.length = 0;
    happens('keydown');
    vi.runAllTimers();
    expect(heard).toEqual(['release', 'key']);
  });

  it('is let go after what its control says at the end', () => {
    happens('pointerdown');
    heard.length = 0;
    happens('pointerup');
    expect(heard).toEqual([]);
    vi.runAllTimers();
    expect(heard).toEqual(['release']);
  });
});
