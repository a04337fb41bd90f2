import type { Editor } from '../editor.ts';
import { frameWords } from '../words/frame.ts';

/**
 * Loads the panels once the first tree has been drawn: until then it has the line and the processor to itself.
 *
 * Where no tree comes there is a message, and the panels come with it: they are how another species is chosen.
 */
export function loadPanels({ session, actions }: Editor): void {
  const load = (): void =>
    void import('./panels.ts').then(
      () => session.setState({ panels: true }),
      (error: unknown) =>
        actions.notify('error', frameWords.panelsFailed, [error instanceof Error ? error.message : String(error)]),
    );
  const stop = session.subscribe(({ tree, notices }) => {
    if (!tree && notices.length === 0) return;
    stop();
    // The frame that draws the tree is the next one.
    requestAnimationFrame(() => requestAnimationFrame(load));
  });
}
