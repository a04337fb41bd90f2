import { type Remote, remote } from './remote.ts';

/** The part of a Worker that is used. */
export type WorkerLike = Pick<Worker, 'postMessage' | 'addEventListener' | 'terminate'>;

/** A worker with its service, and the promise that rejects if its script fails. */
export interface Hand<Service> {
  readonly worker: WorkerLike;
  readonly service: Remote<Service>;
  readonly failed: Promise<never>;
}

/** The worker itself broke: its script did not load, or died. */
export class WorkerFailed extends Error {
  override readonly name = 'WorkerFailed';
}

export function takeOn<Service>(worker: WorkerLike): Hand<Service> {
  const failed = new Promise<never>((_, reject) => {
    worker.addEventListener('error', (event) => {
      const why = (event as ErrorEvent).message || 'its script did not load';
      reject(new WorkerFailed(`The worker that grows trees stopped: ${why}`));
    });
  });
  // Nobody may be asking when it fails; whoever asks next hears of it.
  failed.catch(() => undefined);
  return { worker, service: remote<Service>(worker as Worker), failed };
}

export const letGo = (hand: Hand<unknown>): void => hand.worker.terminate();
