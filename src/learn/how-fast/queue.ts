/** How a timer finds out that the GPU is done. */
export type Waiting = 'none' | 'end' | 'each';

/** A stretch of time on one of the two rows, milliseconds. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
}

/** What happens when frames are handed to a GPU and timed. */
export interface Timeline {
  readonly cpu: readonly Stretch[];
  readonly gpu: readonly Stretch[];
  /** When the timer stops. */
  readonly stop: number;
  /** What it says a frame takes, and what one does. */
  readonly told: number;
}

/** Milliseconds to hand a frame over, and for the word that the GPU is done to come back. */
export const HAND_OVER = 0.8;
export const WORD = 1.5;
/** Frames that a browser lets wait in the queue. */
const QUEUE = 3;

/** Times `frames` frames that take the GPU `cost` milliseconds each. A model, to see what a timer sees; all real queues are messier. */
export function timeline(cost: number, frames: number, waiting: Waiting): Timeline {
  const cpu: Stretch[] = [];
  const gpu: Stretch[] = [];
  let now = 0;
  for (let i = 0; i < frames; i++) {
    // A full queue holds the page until its first frame is begun.
    const held = gpu[i - QUEUE];
    if (held) now = Math.max(now, held.to);
    cpu.push({ from: now, to: now + HAND_OVER });
    now += HAND_OVER;
    const from = Math.max(now, gpu[i - 1]?.to ?? 0);
    gpu.push({ from, to: from + cost });
    if (waiting === 'each') now = from + cost + WORD;
  }
  const last = gpu.at(-1)?.to ?? 0;
  const stop = waiting === 'end' ? last + WORD : now;
  return { cpu, gpu, stop, told: stop / frames };
}
