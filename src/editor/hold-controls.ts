import type { Actions } from './actions.ts';

/** What is dragged: everything that it changes until it is let go is one step of the history. */
const DRAGGED = 'input[type="range"], [role="slider"], [data-drag]';
/** What keys move step by step. */
const STEPPED = `input[type="number"], ${DRAGGED}`;
const STEP_KEYS = new Set(['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'PageUp', 'PageDown', 'Home', 'End']);

const matches = (target: EventTarget | null, selector: string): boolean =>
  target instanceof Element && target.closest(selector) !== null;

/** Tells the history when a control is held, by a pointer or by a key. Returns how to stop. */
export function listenToHolds(actions: Pick<Actions, 'hold' | 'release' | 'holdKey'>): () => void {
  const ends = new AbortController();
  const listen = <K extends keyof WindowEventMap>(type: K, listener: (event: WindowEventMap[K]) => void): void =>
    window.addEventListener(type, listener, { capture: true, signal: ends.signal });
  let releasing: ReturnType<typeof setTimeout> | undefined;
  const settle = (): void => {
    if (releasing === undefined) return;
    clearTimeout(releasing);
    releasing = undefined;
    actions.release();
  };
  /** What a control says as it is let go (`change`, `click`) comes after the pointer's own event. */
  const release = (): void => {
    releasing ??= setTimeout(settle);
  };
  listen('pointerdown', (event) => {
    actions.holdKey(null);
    settle();
    // A colour picker that was left open without a word is closed by now.
    actions.release();
    if (matches(event.target, DRAGGED)) actions.hold();
  });
  listen('pointermove', (event) => {
    // An undo or another window ended the hold, and the drag goes on: what is left of it is one step again.
    if (event.buttons === 0 || !matches(event.target, DRAGGED)) return;
    settle();
    actions.hold();
  });
  listen('pointerup', release);
  listen('pointercancel', release);
  listen('blur', (event) => {
    if (event.target === window) release();
  });
  // A colour picker is a window of its own: its pointer is not seen here.
  listen('input', (event) => {
    if (matches(event.target, 'input[type="color"]')) actions.hold();
  });
  listen('change', (event) => {
    if (matches(event.target, 'input[type="color"]')) release();
  });
  listen('keydown', (event) => {
    // A busy page hears the next key before its timers.
    settle();
    const steps = STEP_KEYS.has(event.key) && matches(event.target, STEPPED);
    actions.holdKey(steps || event.repeat ? event.timeStamp : null, event.repeat);
  });
  return () => ends.abort();
}
