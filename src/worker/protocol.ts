import type { GrownPacked, GrowPackedOptions, GrowStage } from '../core/pack/grow-packed.ts';
import type { Species } from '../core/species/species.ts';

/** Changes with the messages: page and worker come from one build, but a cache may hold an older worker. */
export const PROTOCOL_VERSION = 2;

/** What of a species is grown; `grow` says what each means. */
export type GrowSettings = Pick<GrowPackedOptions, 'levels' | 'leaves' | 'quality' | 'budget'>;

/** What the page asks of the worker. */
export interface GrowRequest {
  readonly version: number;
  readonly species: Species;
  readonly seed: number;
  readonly settings: GrowSettings;
}

/** What it gets: the arrays for the GPU, figures, and how long each stage took. Buffers are handed over, not copied. */
export type GrownTree = Pick<GrownPacked, 'packed' | 'stats' | 'stems' | 'milliseconds'>;

/** How far it is: the stage, and the part of that stage that is done, 0..1. */
export interface GrowProgress {
  readonly stage: GrowStage;
  readonly done: number;
}

/** The worker's side. */
export interface GrowService {
  grow(request: GrowRequest, progress?: (progress: GrowProgress) => void): GrownTree;
}
