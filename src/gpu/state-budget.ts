/** Bytes that the checkpoints of a tree may take on the GPU. */
const BYTES = 24 * 2 ** 20;
const FEWEST = 4;
const MOST = 48;

/** How many checkpoints of `bytes` each are kept: enough for an hour, for a large tree the fewer. */
export const checkpointsFor = (bytes: number): number => Math.min(MOST, Math.max(FEWEST, Math.floor(BYTES / bytes)));

/** Pieces times steps that one update may compute: a tenth of a second on software GL, some milliseconds on a GPU. */
const WORK = { software: 2 ** 19, gpu: 2 ** 23 };
const MOST_STEPS = 400;

/** As many as the longest frame has at the fastest clock (0.25 s, twice as fast): what plays is never caught up with. */
export const LEAST_STEPS = 32;

/** Steps that one update makes at most on a long way. */
export const sliceFor = (pieces: number, software: boolean): number =>
  Math.min(MOST_STEPS, Math.max(LEAST_STEPS, Math.floor((software ? WORK.software : WORK.gpu) / pieces)));

/** Does a renderer of this name compute on the CPU? */
export const isSoftware = (renderer: string): boolean =>
  /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
