import type { LinkDocument } from '../core/link/link.ts';
import { Autosave, type Keep } from './autosave.ts';
import { chooseStart, type Found, type Start } from './choose-start.ts';
import type { DocumentStore } from './document-store.ts';
import type { KeptFile } from './kept-file.ts';
import type { SessionStore } from './session.ts';
import type { Slots } from './slots.ts';
import { readWorkspace, type Workspace } from './workspace.ts';

/** Slots that are kept besides those of living tabs. */
const MOST_SLOTS = 5;

/** Milliseconds that the page waits for the browser's memory before it starts without. */
const PATIENCE = 1500;

/** What a page begins with, and what could not be read of what was kept. */
export type Beginning = Start & {
  /** Work was there that nothing can be made of. */
  readonly broken: boolean;
  /** Parts of what is restored could not be read. */
  readonly cut: boolean;
};

const withoutHandle = (file: KeptFile | null): KeptFile | null => file && { ...file, handle: null };

/** The reader's work as this browser keeps it by itself, a slot for each tab. */
export class Work {
  private readonly keep: Keep;
  private readonly slots: Pick<Slots, 'slot' | 'remembered' | 'living' | 'claim'>;
  private readonly newSlot: () => string;
  /** The page has begun without what was kept. */
  private late = false;
  private readonly found: Promise<{ own: string | null; entries: [string, unknown][]; living: ReadonlySet<string> }>;

  /** Begins to look for what was kept. */
  constructor(keep: Keep, slots: Pick<Slots, 'slot' | 'remembered' | 'living' | 'claim'>, newSlot: () => string) {
    this.keep = keep;
    this.slots = slots;
    this.newSlot = newSlot;
    const nothing = { own: null, entries: [], living: new Set<string>() };
    const late = new Promise<typeof nothing>((done) => {
      setTimeout(() => {
        this.late = true;
        done(nothing);
      }, PATIENCE);
    });
    // No memory at all (a private window): the page starts as on a first visit.
    this.found = Promise.race([this.look().catch(() => nothing), late]);
  }

  private async look() {
    const remembered = this.slots.remembered();
    const entries = await this.keep.entries();
    // A copy of a living tab has its own slot; and where nobody has read what is in a slot, nobody may write over it.
    const own = remembered !== null && !this.late && (await this.slots.claim(remembered));
    return { own: own ? remembered : null, entries, living: await this.slots.living() };
  }

  /** What the page begins with. `link` is what the address asks for, or null; `like` any whole document. */
  async begin(link: LinkDocument | null, like: LinkDocument): Promise<Beginning> {
    const { own, entries, living } = await this.found;
    const free = entries.filter(([slot]) => slot === own || !living.has(slot));
    const cuts = new Set<string>();
    const broken: string[] = [];
    const readable = free.flatMap(([slot, value]): Found[] => {
      const read = readWorkspace(value, like);
      if (!read) broken.push(slot);
      if (read?.cut) cuts.add(slot);
      return read ? [{ slot, workspace: read.workspace }] : [];
    });
    readable.sort((a, b) => b.workspace.when - a.workspace.when);
    const others = readable.filter(({ slot }) => slot !== own);
    const start = chooseStart(link, readable.find(({ slot }) => slot === own) ?? null, others);
    if (start.kind !== 'fresh') await this.adopt(start.found.slot);
    if (this.slots.slot === '') await this.slots.claim(this.newSlot());
    // What is broken is told of once; what is too old goes.
    const late = others.filter(({ slot }) => slot !== this.slots.slot).slice(MOST_SLOTS);
    for (const slot of [...broken, ...late.map((found) => found.slot)]) this.keep.del(slot).catch(() => {});
    const cut = start.kind !== 'fresh' && cuts.has(start.found.slot);
    return { ...start, broken: broken.length > 0, cut };
  }

  /** Goes on in the slot of the work that comes back, unless another tab was faster. */
  private async adopt(slot: string): Promise<void> {
    if (this.slots.slot !== slot) await this.slots.claim(slot);
  }

  /** Keeps from now on what changes. `now` is the document at this moment. */
  follow(document: DocumentStore, session: SessionStore, now: () => LinkDocument, when: () => number): Autosave {
    const { history } = document;
    const read = (): Workspace => {
      const { snapshots, locks, file } = session.getState();
      return { ...history.read(), version: 1, when: when(), document: now(), snapshots, locks: [...locks], file };
    };
    const write = async (): Promise<void> => {
      const work = read();
      const bare = {
        ...work,
        file: withoutHandle(work.file),
        files: work.files.map(({ at, before, after }) => ({
          at,
          before: withoutHandle(before),
          after: withoutHandle(after),
        })),
      };
      // Not every browser can keep what writes a file in place.
      await this.keep.set(this.slots.slot, work).catch((error: unknown) => {
        if (error instanceof DOMException && error.name === 'DataCloneError')
          return this.keep.set(this.slots.slot, bare);
        throw error;
      });
    };
    const save = new Autosave(write, (saved) => {
      if (session.getState().saved !== saved) session.setState({ saved });
    });
    // Who only looks leaves nothing behind.
    let begun = false;
    const touch = (): void => {
      const { snapshots, file } = session.getState();
      begun ||= history.canUndo || history.canRedo || snapshots.length > 0 || file !== null;
      if (begun) save.touch();
    };
    document.subscribe(touch);
    history.subscribe(touch);
    session.subscribe((at, before) => {
      if (at.snapshots !== before.snapshots || at.locks !== before.locks || at.file !== before.file) touch();
    });
    return save;
  }
}
