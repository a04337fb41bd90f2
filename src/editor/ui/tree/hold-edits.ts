import type { Actions } from '../../actions.ts';

const DRAGGED = 'input[type="range"], input[type="color"], [data-drag]';

/** Tells when a control inside of `root` is dragged, or its key is held down: the trees of that time may be drafts. Returns how to stop. */
export function listenToEdits(root: HTMLElement, actions: Pick<Actions, 'holdEdit' | 'releaseEdit'>): () => void {
  const ends = new AbortController();
  const { signal } = ends;
  const dragged = (event: Event): boolean => event.target instanceof Element && event.target.closest(DRAGGED) !== null;
  // The last value is told with the pointer's own event or after it.
  const release = (): void => void setTimeout(actions.releaseEdit);
  root.addEventListener('pointerdown', (e) => dragged(e) && actions.holdEdit(), { signal });
  root.addEventListener('keydown', (e) => e.repeat && e.key.startsWith('Arrow') && actions.holdEdit(), { signal });
  root.addEventListener('keyup', release, { signal });
  root.addEventListener('focusout', release, { signal });
  for (const end of ['pointerup', 'pointercancel', 'blur'] as const) window.addEventListener(end, release, { signal });
  return () => {
    ends.abort();
    actions.releaseEdit();
  };
}
