import type { LitElement } from 'lit';
import type { Editor } from '../editor.ts';
import type { Panel } from '../session.ts';

/** Name of the fold of a panel at a side. */
const folds: Partial<Record<Panel, string>> = { grow: 'grow', wind: 'blow', studio: 'studio' };

/** Resolves when the panels have been loaded. */
const panelsLoaded = ({ session }: Editor): Promise<void> =>
  new Promise((done) => {
    const check = (): void => {
      if (!session.getState().panels) return;
      stop();
      done();
    };
    const stop = session.subscribe(check);
    check();
  });

/** Brings a panel onto the screen: unfolds it at its side, or pulls the sheet up to it; resolves when it stands there. */
export async function showPanel(editor: Editor, panel: Panel): Promise<void> {
  await panelsLoaded(editor);
  const { narrow, detent } = editor.session.getState();
  if (narrow) {
    editor.actions.setTab(panel);
    if (detent === 'bar') editor.actions.setDetent('third');
  } else {
    const fold = folds[panel];
    if (fold) editor.actions.setFold(fold, true);
  }
  // Folds are no part of the session: who reads them is told.
  for (const part of document.querySelectorAll<LitElement>('wg-app, wg-studio')) {
    part.requestUpdate();
    await part.updateComplete;
  }
  // What the panel holds draws itself after it.
  await new Promise((done) => requestAnimationFrame(done));
}

/** Puts the caret into the search of the tree's settings. */
export async function showSearch(editor: Editor): Promise<void> {
  await showPanel(editor, 'grow');
  document.querySelector<HTMLInputElement>('wg-tree input[type="search"]')?.focus();
}
