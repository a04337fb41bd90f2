import { PROJECT_ENDING } from '../core/project/limits.ts';
import type { DocumentStore } from './document-store.ts';
import type { SessionStore } from './session.ts';
import { fileWords } from './words/files.ts';

/** Keeps the window's title: the name of the file, with a dot while it is not saved, or else of the tree. */
export function followTitle(document: DocumentStore, session: SessionStore): void {
  const follow = (): void => {
    const { fileName, changed, tree } = session.getState();
    const name = fileName?.replace(PROJECT_ENDING, '') ?? document.getState().treeName ?? tree?.species.name;
    const title = fileWords.title(name ?? null, fileName !== null && changed);
    if (window.document.title !== title) window.document.title = title;
  };
  document.subscribe(follow);
  session.subscribe(follow);
  follow();
}
