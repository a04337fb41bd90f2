/** Where a tab remembers its slot: a copy of the tab copies it too, and finds it taken. */
const KEY = 'windgrove-slot';
const lockOf = (slot: string): string => `windgrove-slot-${slot}`;

/** Each living tab holds the lock of the slot that it keeps its work in; the browser lets go of it however the tab ends. */
export class Slots {
  /** The slot of this tab; '' until one is claimed. */
  slot = '';

  /** What this tab had before it was loaded again, or null. */
  remembered(): string | null {
    try {
      return sessionStorage.getItem(KEY);
    } catch {
      return null;
    }
  }

  /** Slots that living tabs hold. */
  async living(): Promise<ReadonlySet<string>> {
    const held = (await navigator.locks?.query())?.held ?? [];
    return new Set(held.map(({ name }) => name?.replace(/^windgrove-slot-/, '') ?? ''));
  }

  /** Takes a slot for as long as the page lives; false where another tab has it. */
  async claim(slot: string): Promise<boolean> {
    const got = !navigator.locks || (await this.lock(slot));
    if (!got) return false;
    this.slot = slot;
    try {
      sessionStorage.setItem(KEY, slot);
    } catch {
      // Without it the work is found again as that of a tab which lives no more.
    }
    return true;
  }

  private lock(slot: string): Promise<boolean> {
    return new Promise((done) => {
      const hold = (lock: Lock | null): Promise<void> | undefined => {
        done(lock !== null);
        // Held until the page goes.
        return lock ? new Promise(() => {}) : undefined;
      };
      navigator.locks.request(lockOf(slot), { ifAvailable: true }, hold).catch(() => done(false));
    });
  }
}
