import type { DocumentStore } from './document-store.ts';
import type { DiskFile } from './doing.ts';
import { type Made, madeOf, sameMade } from './made.ts';
import type { SessionStore, Snapshot } from './session.ts';

/** A project's file, and what is in it. */
export interface KeptFile extends DiskFile {
  readonly made: Made;
  /** `snapshotsKey` of the snapshots in it. */
  readonly snapshots: string;
}

/** What differs where other snapshots, or the same under other names, are there. */
export const snapshotsKey = (snapshots: readonly Snapshot[]): string =>
  snapshots.map(({ id, name }) => `${id} ${name}`).join('\n');

/** The file with what is there now in it. */
export const keptFile = ({ name, handle }: DiskFile, document: DocumentStore, session: SessionStore): KeptFile => ({
  name,
  handle,
  made: madeOf(document.getState()),
  snapshots: snapshotsKey(session.getState().snapshots),
});

/** Keeps the session saying whether what is shown differs from its file. */
export function followFile(document: DocumentStore, session: SessionStore): void {
  const follow = (): void => {
    const { file, snapshots, fileName, changed } = session.getState();
    const name = file?.name ?? null;
    const differs =
      file !== null &&
      (file.snapshots !== snapshotsKey(snapshots) || !sameMade(file.made, madeOf(document.getState())));
    if (name !== fileName || differs !== changed) session.setState({ fileName: name, changed: differs });
  };
  document.subscribe(follow);
  session.subscribe((now, before) => {
    if (now.file !== before.file || now.snapshots !== before.snapshots) follow();
  });
  follow();
}
