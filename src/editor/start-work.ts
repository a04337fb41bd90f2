import type { LinkDocument } from '../core/link/link.ts';
import { encodeLink } from '../core/link/link.ts';
import type { Actions } from './actions.ts';
import type { DocumentStore } from './document-store.ts';
import type { SessionStore, Snapshot } from './session.ts';
import { fileWords } from './words/files.ts';
import type { Beginning, Work } from './work.ts';
import type { Workspace } from './workspace.ts';

/** The state that a workspace was left in, as a snapshot among its others. */
function withLast({ document, snapshots, when }: Workspace, slot: string): readonly Snapshot[] {
  const link = encodeLink(document);
  if (snapshots.some((s) => s.link === link)) return snapshots;
  const id = `${slot}-${when.toString(36)}`;
  return [{ id, name: fileWords.beforeLink, when, link, document, thumbnail: null }, ...snapshots];
}

/** What of a document is only looked at. */
const lookOf = ({ time, paused, rate, camera, theme }: LinkDocument): Partial<LinkDocument> => ({
  time,
  paused,
  rate,
  camera,
  theme,
});

/** Puts back what the browser kept, tells of it where the reader did not ask for it, and keeps from now on what changes. */
export function startWork(
  work: Work,
  begin: Beginning,
  page: {
    readonly document: DocumentStore;
    readonly session: SessionStore;
    readonly actions: Pick<Actions, 'notify' | 'newTree' | 'retract'>;
    now(): LinkDocument;
    /** What the address asks for. */
    readonly link: LinkDocument;
  },
): void {
  const { document, session, actions, link } = page;
  if (begin.kind === 'fresh') {
    if (begin.before) session.setState({ snapshots: withLast(begin.before.workspace, begin.before.slot) });
  } else {
    const { workspace } = begin.found;
    const { snapshots, locks, file } = workspace;
    const told = begin.kind === 'restored' && begin.told;
    document.setState({ ...workspace.document, ...(told ? {} : lookOf(link)) });
    document.history.replace(workspace);
    session.setState({ snapshots, locks: new Set(locks), file });
    if (begin.kind === 'continued') document.setState(link);
    if (told) tellBack(workspace.when);
  }
  if (begin.broken) actions.notify('warning', fileWords.broken, fileWords.brokenLines);
  else if (begin.cut) actions.notify('warning', fileWords.brokenSteps, fileWords.brokenLines);

  const save = work.follow(document, session, page.now, Date.now);
  window.addEventListener('pagehide', () => save.hurry());
  window.document.addEventListener('visibilitychange', () => save.hurry());

  /** Who goes on with the tree has seen that it is back. */
  function tellBack(when: number): void {
    const title = fileWords.back(when);
    actions.notify('note', title, [], { label: fileWords.startFresh, act: actions.newTree });
    const { states } = document.history;
    const stop = document.history.subscribe(() => {
      if (document.history.states.length === states.length && document.history.index === states.length - 1) return;
      stop();
      actions.retract(title);
    });
  }
}
