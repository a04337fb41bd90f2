/** Where values are kept by key. */
export interface Keep {
  entries(): Promise<[key: string, value: unknown][]>;
  set(key: string, value: unknown): Promise<void>;
  del(key: string): Promise<void>;
}

/** Milliseconds from a change to its writing: what changes meanwhile is written with it. */
const PACE = 400;

/**
 * Writes what `read` gives, soon after each change and never twice at a time. `onState` hears how that goes.
 *
 * A crash takes at most the changes of the last second.
 */
export class Autosave {
  private timer: ReturnType<typeof setTimeout> | null = null;
  private writing = false;
  private again = false;

  private readonly write: () => Promise<void>;
  private readonly onState: (state: 'saved' | 'saving' | 'failed') => void;

  constructor(write: () => Promise<void>, onState: (state: 'saved' | 'saving' | 'failed') => void) {
    this.write = write;
    this.onState = onState;
  }

  /** Something changed. */
  touch(): void {
    this.timer ??= setTimeout(() => void this.flush(), PACE);
  }

  /** Writes what waits; resolves when it is written. */
  async flush(): Promise<void> {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    if (this.writing) {
      this.again = true;
      return;
    }
    this.writing = true;
    this.onState('saving');
    try {
      do {
        this.again = false;
        await this.write();
      } while (this.again);
      this.onState('saved');
    } catch {
      // A private window or a full disk: the editor works, and its save state says so. The next change tries again.
      this.onState('failed');
    } finally {
      this.writing = false;
    }
  }

  /** Writes what waits, if anything does: the page may be gone in a moment. */
  hurry(): void {
    if (this.timer !== null) void this.flush();
  }
}
