import type { LitElement } from 'lit';
import { PLACES } from '../../../core/species/edits.ts';
import type { Editor } from '../../editor.ts';
import { showPanel } from '../show-panel.ts';
import { idOf } from './context.ts';

/** Shows the control of a parameter, wherever it is folded away, and puts the focus into it. */
export async function revealParameter(editor: Editor, path: string): Promise<void> {
  const place = PLACES.get(path);
  if (!place) return;
  const fold = place.level === undefined ? place.parameter.group : 'levels';
  if (place.level !== undefined) editor.actions.setLevel(place.level);
  editor.actions.setFold(`tree-${fold}`, true);
  await showPanel(editor, 'grow');
  const tree = document.querySelector<LitElement>('wg-tree');
  if (!tree) return;
  unfilter(tree);
  // A fold is no part of the session: who reads it is told.
  tree.requestUpdate('editor', null);
  await tree.updateComplete;
  const control = ['', '-number', '-about']
    .map((part) => tree.querySelector<HTMLElement>(`#${idOf(path)}${part}`))
    .find((found) => found?.matches('input:not(:disabled), select, button'));
  control?.scrollIntoView({ block: 'center' });
  control?.focus();
}

/** What is searched for, or only what was changed, may be all but this one. */
function unfilter(tree: HTMLElement): void {
  const search = tree.querySelector<HTMLInputElement>('input[type="search"]');
  if (search?.value) {
    search.value = '';
    search.dispatchEvent(new Event('input', { bubbles: true }));
  }
  const changed = tree.querySelector<HTMLInputElement>('#changed-only');
  if (changed?.checked) changed.click();
}
