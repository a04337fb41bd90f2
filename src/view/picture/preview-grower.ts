import type { Species } from '../../core/species/species.ts';
import { GrowAborted, type GrowOptions, isAborted, newGrowClient } from '../../worker/client.ts';
import type { GrownTree } from '../../worker/protocol.ts';

/** Whether an error only says that a preview is no longer wanted. */
export { isAborted };

/** What of a tree a preview grows. */
export type PreviewSettings = Pick<GrowOptions, 'levels' | 'leaves' | 'quality'>;

interface Wish {
  readonly start: () => void;
  readonly drop: () => void;
}

/**
 * Grows trees beside the one that is edited, one after another, in a worker of its own: the page's own client lets the newest wish win.
 *
 * Every wish is answered in its turn, or rejects (`isAborted`) once `clear` or `dispose` is called. The worker starts with the first wish.
 */
export class PreviewGrower {
  private readonly client = newGrowClient();
  private waiting: Wish[] = [];
  private busy = false;

  /** Grows a tree when all that were asked for before are there. */
  grow(species: Species, seed: number, settings: PreviewSettings = {}, signal?: AbortSignal): Promise<GrownTree> {
    return new Promise((resolve, reject) => {
      const drop = (): void => reject(new GrowAborted('cancelled'));
      this.waiting.push({
        drop,
        start: () => {
          if (signal?.aborted) {
            this.done();
            drop();
            return;
          }
          void this.client
            .grow(species, seed, { ...settings, ...(signal ? { signal } : {}) })
            .then(resolve, reject)
            .finally(() => this.done());
        },
      });
      this.next();
    });
  }

  /** Drops all that was asked for. */
  clear(): void {
    const dropped = this.waiting;
    this.waiting = [];
    this.client.cancel();
    for (const { drop } of dropped) drop();
  }

  /** Drops all and ends the worker; a later wish starts another. */
  dispose(): void {
    this.clear();
    this.client.dispose();
  }

  private next(): void {
    if (this.busy) return;
    const wish = this.waiting.shift();
    if (!wish) return;
    this.busy = true;
    wish.start();
  }

  private done(): void {
    this.busy = false;
    this.next();
  }
}
