import type { Actions } from './actions.ts';
import { isWindText } from './open-file.ts';

/** Takes a wind that is pasted anywhere on the page; what is pasted into a box is the box's. */
export function listenToPastes(actions: Actions): void {
  window.addEventListener('paste', (event) => {
    const { target } = event;
    if (event.defaultPrevented) return;
    if (target instanceof Element && target.closest('input, textarea, [contenteditable]')) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (!isWindText(text)) return;
    event.preventDefault();
    actions.pasteWind(text);
  });
}
