import type { Insets } from '../view/picture/picture.ts';
import { watch } from './document-store.ts';
import type { SessionStore } from './session.ts';

/** Below this many pixels there is no room for panels at both sides. */
const NARROW = 768;

/** Keeps `session.narrow` and the class `narrow` of the page. */
export function followWidth(session: SessionStore): void {
  const query = matchMedia(`(max-width: ${NARROW - 1}px)`);
  const apply = (): void => {
    document.documentElement.classList.toggle('narrow', query.matches);
    session.setState({ narrow: query.matches });
  };
  query.addEventListener('change', apply);
  apply();
}

/** What the panels cover now. */
function measure(root: Element): Insets {
  const rect = (selector: string): DOMRect | undefined => root.querySelector(selector)?.getBoundingClientRect();
  const frame = rect('.photo-frame');
  if (frame)
    return {
      top: frame.top,
      left: frame.left,
      right: window.innerWidth - frame.right,
      bottom: window.innerHeight - frame.bottom,
    };
  const top = rect('.top')?.bottom ?? 0;
  if (document.documentElement.classList.contains('narrow')) {
    // Pulled up all the way, the sheet hides the tree; it is not squeezed into the strip that is left.
    const height = root.querySelector<HTMLElement>('.sheet')?.offsetHeight ?? 0;
    return { top, left: 0, right: 0, bottom: Math.min(height, 0.66 * window.innerHeight) };
  }
  const left = rect('.side.grow:not([data-folded])')?.right ?? 0;
  const right = rect('.side.blow:not([data-folded])')?.left ?? window.innerWidth;
  const bottom = rect('.bottom')?.top ?? window.innerHeight;
  return { top, left, right: window.innerWidth - right, bottom: window.innerHeight - bottom };
}

/** Tells what the panels cover, at once and whenever they change. */
export function followInsets(root: Element, session: SessionStore, onInsets: (insets: Insets) => void): void {
  let before = '';
  const tell = (): void => {
    const insets = measure(root);
    const now = JSON.stringify(insets);
    if (now !== before) onInsets(insets);
    before = now;
  };
  const sizes = new ResizeObserver(tell);
  const look = (): void => {
    sizes.disconnect();
    sizes.observe(root);
    for (const part of root.querySelectorAll('.side, .sheet, .bottom, .top, .photo-frame')) sizes.observe(part);
    tell();
  };
  for (const which of ['narrow', 'photo'] as const) {
    watch(
      session,
      (s) => s[which],
      () => requestAnimationFrame(look),
    );
  }
  // The frame of photo mode comes when its code has been loaded.
  root.addEventListener('photo-frame', look);
  look();
}
