import type { Doing } from './doing.ts';
import { changeLabel } from './history-label.ts';
import { namesIn } from './history-names.ts';
import { historyWords, stepWords } from './words/history.ts';

/** What a reader can do to the history. */
export function historyActions({ document, session, say }: Doing) {
  const { history } = document;
  const follow = (): void => {
    const { canUndo, canRedo } = history;
    const now = session.getState();
    if (canUndo !== now.canUndo || canRedo !== now.canRedo) session.setState({ canUndo, canRedo });
  };
  history.subscribe(follow);
  follow();
  /** What was chosen in another state may not be there. */
  const settle = (): void => {
    const { compare, wind } = document.getState();
    const { side, gust } = session.getState();
    const edited = (side === 'B' && compare ? compare.wind : wind).gusts;
    if (side === 'B' && !compare) session.setState({ side: 'A' });
    if (gust !== null && gust >= edited.length) session.setState({ gust: null });
  };
  const names = namesIn(session);
  /** What was done from the state at `index` to the next one; '' where there is none. */
  const stepAt = (index: number): string => {
    const { states } = history;
    const [from, to] = [states[index], states[index + 1]];
    return from && to ? changeLabel(from, to, names) : '';
  };
  const go = (move: () => boolean, spoken: () => string): void => {
    const words = spoken();
    if (!move()) return;
    settle();
    say(words);
  };

  return {
    undo: () =>
      go(
        () => history.undo(),
        () => historyWords.undone(stepAt(history.index - 1)),
      ),
    redo: () =>
      go(
        () => history.redo(),
        () => historyWords.redone(stepAt(history.index)),
      ),
    /** To a place of the list that the history shows. */
    goTo: (index: number) =>
      go(
        () => history.goTo(index),
        () => historyWords.wentTo(index === 0 ? stepWords.start : stepAt(index - 1)),
      ),
    /** What undo would take back and redo do again, in a few words; '' where nothing. */
    undoText: (): string => stepAt(history.index - 1),
    redoText: (): string => stepAt(history.index),
    /** All changes until `release` are one step: a control is being dragged. */
    hold: () => history.hold(),
    release: () => history.release(),
    /** The changes that follow come from a key pressed at `at` milliseconds, `held` down since; null: from elsewhere. */
    holdKey: (at: number | null, held = false) => history.key(at, held),
  };
}
