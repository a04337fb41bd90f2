import type { BarkMeshOptions } from '../../core/mesh/bark-mesh.ts';
import { countInWorker, type MeshCount } from '../../view/picture/export-in-worker.ts';
import type { ShownTree } from '../session.ts';

/** Counts the meshes that an export would make, in a worker, and remembers those of the present tree; the newest wish wins. */
export class MeshCounter {
  private readonly changed: () => void;
  private readonly known = new Map<string, readonly MeshCount[]>();
  private tree: ShownTree | null = null;
  private running: { readonly key: string; readonly abort: AbortController; failed: boolean } | null = null;

  constructor(changed: () => void) {
    this.changed = changed;
  }

  /** The counts, or null until they are there: then the page is told. */
  of(tree: ShownTree, meshes: readonly BarkMeshOptions[]): readonly MeshCount[] | null {
    if (tree !== this.tree) {
      this.stop();
      this.known.clear();
      this.tree = tree;
    }
    if (meshes.length === 0) return null;
    const key = JSON.stringify(meshes);
    const found = this.known.get(key);
    if (!found && this.running?.key !== key) void this.count(tree, meshes, key);
    return found ?? null;
  }

  get busy(): boolean {
    return this.running !== null && !this.running.failed;
  }

  stop(): void {
    this.running?.abort.abort();
    this.running = null;
  }

  private async count(tree: ShownTree, meshes: readonly BarkMeshOptions[], key: string): Promise<void> {
    this.stop();
    const abort = new AbortController();
    const running = { key, abort, failed: false };
    this.running = running;
    try {
      const counts = await countInWorker({ species: tree.species, seed: tree.seed, meshes }, abort.signal);
      if (abort.signal.aborted) return;
      this.known.set(key, counts);
      this.running = null;
      this.changed();
    } catch {
      running.failed = true;
      if (!abort.signal.aborted) this.changed();
      // Without an estimate the export is as good; what is wrong it says itself. The key stays, so that nobody asks again at once.
    }
  }
}
