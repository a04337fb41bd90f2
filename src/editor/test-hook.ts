import type { LinkDocument } from '../core/link/link.ts';
import type { OnScreen, Picture } from '../view/picture/picture.ts';
import type { Editor } from './editor.ts';

/** What tests and curious people may ask the page for: `window.windgrove`. */
export interface TestHook {
  /** The document: what the link holds. */
  state(): LinkDocument;
  /** The time that was drawn last, seconds. */
  time(): number;
  seek(seconds: number): void;
  step(steps?: number): void;
  /** Resolves once the wished tree is on the screen and nothing is left to draw; never while playing. */
  settled(): Promise<void>;
  /** Tips (P3) of all pieces as drawn last, read back from the GPU: 3 a piece, tree space, metres. */
  tips(): number[];
  /** Where the branches were drawn last, and the horizon, in pixels of the window. */
  onScreen(): OnScreen;
  /** The picture without the interface at the time that was drawn last, as a data: address of a PNG. */
  picture(): string;
}

declare global {
  interface Window {
    windgrove?: TestHook;
  }
}

/** Hangs the hook on the window. */
export function installTestHook(
  editor: Editor,
  picture: Picture,
  loop: { readonly idle: boolean; onFrame: (listener: () => void) => () => void },
  isCurrent: () => boolean,
): void {
  window.windgrove = {
    state: () => editor.document.getState(),
    time: () => editor.actions.time(),
    seek: (seconds) => editor.actions.seek(seconds),
    step: (steps = 1) => editor.actions.step(steps),
    settled: () =>
      new Promise((done) => {
        const check = (): boolean => isCurrent() && loop.idle;
        if (check()) return done();
        const stop = loop.onFrame(() => {
          if (!check()) return;
          stop();
          done();
        });
      }),
    picture: () => picture.capture(editor.actions.time()),
    onScreen: () => picture.onScreen(),
    tips: () => [...picture.tips()],
  };
}
