import { growPacked } from '../core/pack/grow-packed.ts';
import type { Species } from '../core/species/species.ts';
import { GrowAborted, type GrowOptions } from './client.ts';
import type { GrownTree } from './protocol.ts';

/** Grows a tree on this thread, which stands still meanwhile: where there are no workers. Throws as `growPacked`, and GrowAborted. */
export function growHere(species: Species, seed: number, { signal, onProgress, ...settings }: GrowOptions): GrownTree {
  if (signal?.aborted) throw new GrowAborted('cancelled');
  const { packed, stats, stems, milliseconds } = growPacked(species, seed, {
    ...settings,
    now: () => performance.now(),
    onProgress: (stage, done) => onProgress?.({ stage, done }),
  });
  return { packed, stats, stems, milliseconds };
}
