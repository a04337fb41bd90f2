import { type GroveLight, groveLight } from '../core/look/grove-light.ts';
import { growPacked } from '../core/pack/grow-packed.ts';
import { mergeTrees, type PackedGrove, type Standing } from '../core/pack/merge-trees.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import {
  GROVE_PROTOCOL_VERSION,
  type GroveForm,
  type GroveRequest,
  type GroveService,
  type GrownGrove,
} from './grove-protocol.ts';
import { handOver } from './remote.ts';
import { buffersOf } from './service.ts';
import { TreeCache } from './tree-cache.ts';

/** Bytes of trees that a worker keeps: some ninety aspens. */
const KEPT = 128 * 2 ** 20;

/** What the service is made with. */
export interface GroveServiceOptions {
  /** Makes the middle form of a full tree. */
  readonly middle: (tree: PackedTree, species: Species) => PackedTree;
  readonly bytes?: number;
}

/** Lets messages in: a request may have been cancelled meanwhile. */
const turnOfEvents = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** Grows groves; trees of one seed are grown once and kept. Apart from the worker's script so that a test can hold it. */
export function groveService({ middle, bytes = KEPT }: GroveServiceOptions): GroveService {
  const cache = new TreeCache(bytes);
  const lights = new Map<string, GroveLight>();
  const cancelled = new Set<number>();

  function treeOf(species: Species, name: string, seed: number, form: GroveForm): { tree: PackedTree; fresh: boolean } {
    const kept = cache.get(`${form} ${seed} ${name}`);
    // The light is found in a full tree: where there is none yet, one is grown.
    if (kept && lights.has(name)) return { tree: kept, fresh: false };
    const known = cache.get(`full ${seed} ${name}`);
    const full = known ?? growPacked(species, seed).packed;
    if (!lights.has(name)) lights.set(name, groveLight(full, species));
    const tree = form === 'full' ? full : middle(full, species);
    cache.put(`${form} ${seed} ${name}`, tree);
    return { tree, fresh: !known };
  }

  return {
    async growGrove(version, id, { species, members, form }: GroveRequest): Promise<GrownGrove> {
      if (version !== GROVE_PROTOCOL_VERSION) {
        throw new Error(
          `The page (groves ${version}) and its worker (${GROVE_PROTOCOL_VERSION}) differ: reload the page.`,
        );
      }
      try {
        const name = JSON.stringify(species);
        const began = performance.now();
        const standings: Standing[] = [];
        let grown = 0;
        for (const { seed, ...place } of members) {
          const { tree, fresh } = treeOf(species, name, seed, form);
          if (fresh) {
            grown++;
            await turnOfEvents();
          }
          if (cancelled.has(id)) throw new Error('cancelled: the grove is no longer wanted');
          standings.push({ ...place, tree });
        }
        const all = performance.now();
        const packed = mergeTrees(standings);
        const milliseconds = { grow: all - began, merge: performance.now() - all };
        const light = lights.get(name) as GroveLight;
        return handOver({ packed, light, grown, milliseconds }, groveBuffers(packed));
      } finally {
        cancelled.delete(id);
      }
    },
    cancel: (id) => {
      cancelled.add(id);
    },
  };
}

/** Every buffer of a grove; its light is the worker's own and is copied. */
const groveBuffers = (packed: PackedGrove): ArrayBuffer[] => [
  ...buffersOf(packed),
  packed.trees.data.buffer as ArrayBuffer,
];
