import { oneLine } from '../core/file/one-line.ts';
import { LONGEST_SNAPSHOT_NAME, MOST_SNAPSHOTS } from '../core/project/limits.ts';
import type { Doing } from './doing.ts';
import { linkFaultLines } from './link-faults.ts';
import type { Snapshot } from './session.ts';
import { snapshotWords } from './words/files.ts';

/** `name` where no snapshot has it, else `name 2`, `name 3`, ... */
function freeName(name: string, taken: readonly Snapshot[]): string {
  const names = new Set(taken.map((s) => s.name));
  if (!names.has(name)) return name;
  for (let i = 2; ; i++) if (!names.has(`${name} ${i}`)) return `${name} ${i}`;
}

/** What a reader can do to named states. */
export function snapshotActions({ document, session, services, say, notify }: Doing) {
  const all = (): readonly Snapshot[] => session.getState().snapshots;
  const put = (snapshots: readonly Snapshot[]): void => session.setState({ snapshots });
  const change = (id: string, to: Partial<Snapshot>): void =>
    put(all().map((snapshot) => (snapshot.id === id ? { ...snapshot, ...to } : snapshot)));
  const tidy = (name: string): string => oneLine(name.replace(/\s+/g, ' ').trim(), LONGEST_SNAPSHOT_NAME - 4);
  const suggested = (): string => {
    const { treeName, seed } = document.getState();
    const { tree } = session.getState();
    return snapshotWords.nameOf(treeName ?? tree?.species.name ?? '', seed);
  };

  /** Keeps a document under a name; the picture comes later. null: there are as many as can be. */
  const keep = (name: string, picture: () => Promise<string | null>): Snapshot | null => {
    if (all().length >= MOST_SNAPSHOTS) return null;
    const now = services.now();
    const when = services.when();
    const id = `${when.toString(36)}-${all().length}-${crypto.getRandomValues(new Uint32Array(1))[0]!.toString(36)}`;
    const link = new URL(services.addressOf(now)).hash.slice(1);
    const snapshot: Snapshot = { id, name: freeName(name, all()), when, link, document: now, thumbnail: null };
    put([snapshot, ...all()]);
    // What is shown may be gone when the picture comes; then it stays without.
    void picture().then(
      (thumbnail) => change(id, { thumbnail }),
      () => {},
    );
    return snapshot;
  };

  return {
    /** Keeps the document under a name; without one it is called after the tree. */
    takeSnapshot(name: string): void {
      const kept = keep(tidy(name) || suggested(), services.thumbnail);
      if (kept) say(snapshotWords.taken(kept.name));
      else notify('warning', snapshotWords.most(MOST_SNAPSHOTS));
    },
    /** Keeps what is about to go, in silence; returns its name, or null where nothing more can be kept. */
    keepBefore: (name: string): string | null => keep(tidy(name), services.thumbnail)?.name ?? null,
    /** Shows it; one step, so that undo comes back. */
    openSnapshot(id: string): void {
      const snapshot = all().find((s) => s.id === id);
      if (!snapshot) return;
      const { theme } = document.getState();
      const { document: whole, faults } = snapshot.document
        ? { document: snapshot.document, faults: [] }
        : services.read(snapshot.link);
      services.show({ ...whole, theme });
      if (faults.length > 0) notify('warning', snapshotWords.broken(snapshot.name), linkFaultLines(faults));
      say(snapshot.name);
    },
    /** An empty name changes nothing. */
    renameSnapshot(id: string, name: string): void {
      const tidied = tidy(name);
      const others = all().filter((s) => s.id !== id);
      if (tidied !== '') change(id, { name: freeName(tidied, others) });
    },
    /** Deletes it; a message offers to put it back. */
    deleteSnapshot(id: string): void {
      const place = all().findIndex((s) => s.id === id);
      const snapshot = all()[place];
      if (!snapshot) return;
      put(all().toSpliced(place, 1));
      const act = (): void => {
        if (!all().some((s) => s.id === id)) put(all().toSpliced(place, 0, snapshot));
      };
      notify('note', snapshotWords.deleted(snapshot.name), [], { label: snapshotWords.putBack, act });
    },
  };
}
