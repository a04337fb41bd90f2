import { type DriveStep, driver } from 'driver.js';
import 'driver.js/dist/driver.css';
import './styles/tour.css';
import { watch } from './document-store.ts';
import type { Editor } from './editor.ts';
import { prepareStop, type TourStop, tourStops } from './tour-stops.ts';
import { tourWords } from './words/tour.ts';

/** Milliseconds of a move from stop to stop. */
const MOVE = 200;

/** Where the tour can be begun again: the help, on a narrow window the menu that has it. */
const ENTRANCE = '.top .finding button:last-child, .top [popovertarget="more-menu"]';

const step = ({ id, at, side, text }: TourStop): DriveStep => ({
  element: at,
  popover: {
    title: tourWords.stops[id].title,
    description: text,
    ...(side === undefined ? {} : { side, align: at === '.sheet' ? ('center' as const) : ('start' as const) }),
    popoverClass: `tour tour-${id}`,
  },
});

/** Shows the reader around; ends when the last stop is done, when it is closed, or when another dialog opens. */
export async function startTour(editor: Editor): Promise<void> {
  const stops = tourStops(editor);
  const { narrow } = editor.session.getState();
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const from = document.activeElement instanceof HTMLElement ? document.activeElement : null;
  let at = 0;
  const go = async (index: number): Promise<void> => {
    const stop = stops[index];
    if (!stop) {
      if (index >= stops.length) tour.destroy();
      return;
    }
    at = index;
    await prepareStop(editor, stop);
    // Who goes on meanwhile is already at another stop.
    if (tour.isActive() && at === index) tour.moveTo(index);
  };
  /** The library's own keys do nothing while it moves from stop to stop, and take the arrows of the controls that it points at. */
  const onKey = (event: KeyboardEvent): void => {
    const { target, key } = event;
    if (target instanceof Element && target.closest('input, select, textarea, [role="slider"], [role="tab"]')) return;
    if (key === 'Escape') tour.destroy();
    else if (key === 'ArrowRight') void go(at + 1);
    else if (key === 'ArrowLeft') void go(at - 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const tour = driver({
    steps: stops.map(step),
    animate: !still,
    duration: MOVE,
    overlayColor: 'var(--tour-shade)',
    overlayOpacity: 0.55,
    stagePadding: 4,
    stageRadius: 4,
    showProgress: true,
    progressText: tourWords.progress,
    nextBtnText: tourWords.next,
    prevBtnText: tourWords.back,
    doneBtnText: tourWords.done,
    // What is pointed at can be used: nobody learns by looking alone. A stray click beside it ends nothing.
    overlayClickBehavior: () => {},
    onPopoverRender: ({ closeButton, title, footer }) => {
      closeButton.setAttribute('aria-label', tourWords.close);
      // The library's header and footer would count as those of the page.
      title.setAttribute('role', 'none');
      footer.setAttribute('role', 'group');
    },
    onHighlighted: (_element, _step, { state }) => state.popover?.nextButton.focus(),
    allowKeyboardControl: false,
    onNextClick: () => void go(at + 1),
    onPrevClick: () => void go(at - 1),
    onDestroyed: () => {
      stop();
      window.removeEventListener('keydown', onKey, true);
      if (editor.session.getState().dialog === 'tour') editor.actions.closeDialog();
      // The button that began it may have gone with the hint.
      const back = from?.isConnected && from !== document.body ? from : document.querySelector<HTMLElement>(ENTRANCE);
      if (editor.session.getState().dialog === null) back?.focus();
    },
  });
  const stop = watch(
    editor.session,
    (s) => s.dialog === 'tour' && s.narrow === narrow,
    (on) => {
      if (!on) tour.destroy();
    },
  );
  editor.actions.hideHint();
  await prepareStop(editor, stops[0]!);
  window.addEventListener('keydown', onKey, true);
  tour.drive();
}
