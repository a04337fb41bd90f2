/** What several rounds of the same work took. */
export interface RoundsTimed {
  /** Milliseconds of one run: median and least over the rounds. */
  readonly median: number;
  readonly least: number;
  /** Rounds, and runs in each. */
  readonly rounds: number;
  readonly runs: number;
}

export interface RoundsOptions {
  /** Default 7. */
  readonly rounds?: number;
  /** Least milliseconds of a round, which should be long beside the 4 of a timer's step; default 120. */
  readonly milliseconds?: number;
  /** Aborting it rejects with its reason before the next round. */
  readonly signal?: AbortSignal;
}

const MOST_RUNS = 4000;

const pause = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

/**
 * Resolves when the GPU has done all that it has been asked for, without holding the page: a fence is asked again between tasks. Rejects where the
 * context is lost.
 */
export async function gpuDone(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) throw new Error('the graphics context was lost.');
  gl.flush();
  for (;;) {
    const state = gl.clientWaitSync(fence, 0, 0);
    if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED) break;
    if (state === gl.WAIT_FAILED || gl.isContextLost()) throw new Error('the graphics context was lost.');
    await pause(1);
  }
  gl.deleteSync(fence);
}

/**
 * Times `run`, work for the GPU, in rounds of many runs, each round waited for by `done` and the page left free between; warm-up and calibration go before. `now`
 * is a clock in milliseconds.
 */
export async function timedRounds(
  run: () => void,
  done: () => Promise<void>,
  { rounds = 7, milliseconds = 120, signal }: RoundsOptions = {},
  now: () => number = () => performance.now(),
): Promise<RoundsTimed> {
  const round = async (runs: number): Promise<number> => {
    await pause(0);
    signal?.throwIfAborted();
    const start = now();
    for (let i = 0; i < runs; i++) run();
    await done();
    return now() - start;
  };
  await round(1); // compiles and uploads
  let runs = 1;
  let taken = await round(runs);
  // One run of a fast machine is shorter than the waiting for it: more, until a round is long.
  while (taken < milliseconds * 0.7 && runs < MOST_RUNS) {
    runs = Math.min(MOST_RUNS, Math.ceil(runs * Math.min(8, (milliseconds * 1.1) / Math.max(taken, 0.1))));
    taken = await round(runs);
  }
  const times: number[] = [];
  for (let i = 0; i < rounds; i++) times.push((await round(runs)) / runs);
  times.sort((a, b) => a - b);
  return { median: times[times.length >> 1] as number, least: times[0] as number, rounds, runs };
}
