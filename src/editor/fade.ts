import type { Wind } from '../core/wind/wind.ts';

/** Seconds that a change of the wind takes while time runs: into another wind or another bend model, and of a number under the reader's hand. */
const INTO_ANOTHER = 1.2;
const UNDER_THE_HAND = 0.4;

/** How long the change from one wind to the next takes. */
export const fadeOf = (now: Wind, before: Wind): number =>
  now.name === before.name && now.waves.length === before.waves.length && now.model === before.model
    ? UNDER_THE_HAND
    : INTO_ANOTHER;
