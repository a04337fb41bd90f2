import { growPacked } from '../core/pack/grow-packed.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import { stemBuffers } from '../core/pack/stem-table.ts';
import { type GrowProgress, type GrowRequest, type GrowService, PROTOCOL_VERSION } from './protocol.ts';
import { handOver } from './remote.ts';

/** Least part of a stage between two messages of progress: a message costs more than a stem. */
const STEP = 0.02;

/** What the worker offers; apart from the worker's script so that a test can hold it at the end of any channel. */
export const growService: GrowService = {
  grow({ version, species, seed, settings }: GrowRequest, progress?: (progress: GrowProgress) => void) {
    if (version !== PROTOCOL_VERSION) {
      throw new Error(`The page (protocol ${version}) and its worker (${PROTOCOL_VERSION}) differ: reload the page.`);
    }
    let last: GrowProgress | undefined;
    const onProgress = (stage: GrowProgress['stage'], done: number): void => {
      if (!progress || (last && last.stage === stage && done - last.done < STEP && done < 1)) return;
      last = { stage, done };
      progress(last);
    };
    const now = (): number => performance.now();
    const { packed, stats, stems, milliseconds } = growPacked(species, seed, { ...settings, now, onProgress });
    return handOver({ packed, stats, stems, milliseconds }, [...buffersOf(packed), ...stemBuffers(stems)]);
  },
};

/** Every buffer of a packed tree. */
export const buffersOf = (packed: PackedTree): ArrayBuffer[] =>
  [
    packed.depthStart,
    packed.pieces.data,
    packed.restPose.data,
    packed.branches.data,
    packed.leaves.data,
    packed.mechanics,
    packed.bounds,
    packed.crown,
  ].map((array) => array.buffer as ArrayBuffer);
