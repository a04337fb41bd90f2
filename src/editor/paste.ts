import type { Actions } from './actions.ts';
import { isFileText, isWindText } from './file-kinds.ts';
import { fileWords } from './words/files.ts';

/** Takes a wind, a tree or a project that is pasted anywhere on the page; what is pasted into a box is the box's. */
export function listenToPastes(actions: Actions): void {
  window.addEventListener('paste', (event) => {
    const { target } = event;
    if (event.defaultPrevented) return;
    if (target instanceof Element && target.closest('input, textarea, [contenteditable]')) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (!isFileText(text)) return;
    event.preventDefault();
    if (isWindText(text)) actions.pasteWind(text);
    else void actions.openText(text, fileWords.pasted);
  });
}
