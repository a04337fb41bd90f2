import type { GroveLight } from '../core/look/grove-light.ts';
import type { PackedGrove } from '../core/pack/merge-trees.ts';
import type { Species } from '../core/species/species.ts';

/** Changes with the messages, as PROTOCOL_VERSION does. */
export const GROVE_PROTOCOL_VERSION = 1;

/** `full`: all levels and leaves. `middle`: the motion of whole branches, and cards in place of leaves. */
export type GroveForm = 'full' | 'middle';

/** A tree of a grove: metres from the grove's origin, radians from x to y; `phase` as mergeTrees takes it. */
export interface GroveMember {
  readonly seed: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly turn: number;
  readonly phase?: number;
}

/** A grove that is asked for: trees of one species. */
export interface GroveRequest {
  readonly species: Species;
  readonly members: readonly GroveMember[];
  readonly form: GroveForm;
}

/** What comes: arrays for the GPU, whose buffers are handed over, and how long it took. */
export interface GrownGrove {
  readonly packed: PackedGrove;
  /** Found in the first tree that the worker grew of the species. */
  readonly light: GroveLight;
  /** Trees that had to be grown; the others were kept from before. */
  readonly grown: number;
  readonly milliseconds: { readonly grow: number; readonly merge: number };
}

/** The worker's side. `id` names a request for `cancel`, which stops it between two trees. */
export interface GroveService {
  growGrove(version: number, id: number, request: GroveRequest): Promise<GrownGrove>;
  cancel(id: number): void;
}
