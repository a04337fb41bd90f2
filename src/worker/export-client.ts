import type { ExportFile, ExportOptions } from '../core/io/export-options.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { WorkerLike } from './client.ts';
import type { CountRequest, ExportProgress, ExportService, MeshCount } from './export-service.ts';
import { type Remote, remote } from './remote.ts';
import { trustedWorker } from './trusted-worker.ts';

export type { CountRequest, ExportProgress, MeshCount } from './export-service.ts';

export interface ExportInWorkerOptions {
  /** Aborting it ends the worker and rejects with the signal's reason (an `AbortError` by default). */
  readonly signal?: AbortSignal;
  /** Called while files are written, never after the promise is settled. */
  readonly onProgress?: (progress: ExportProgress) => void;
}

const spawnWorker = (Worker = trustedWorker()): WorkerLike =>
  new Worker(new URL('./export.worker.ts', import.meta.url), { type: 'module', name: 'export' });

/**
 * Writes a tree as files in a worker of its own, which ends with the work: an export is rare, long, and takes much memory.
 *
 * The page stays awake, and a tree that grows meanwhile need not wait. Rejects with the export's own error, with the signal's reason, or
 * with an Error where the worker's script did not load or died.
 */
export function exportWithWorker(
  species: Species,
  seed: number,
  wind: Wind,
  options: ExportOptions,
  { signal, onProgress }: ExportInWorkerOptions = {},
  spawn: () => WorkerLike = () => spawnWorker(),
): Promise<ExportFile[]> {
  let settled = false;
  const report = onProgress && ((progress: ExportProgress) => void (settled || onProgress(progress)));
  const asked = inWorker(spawn, signal, (service) => service.write({ species, seed, wind, options }, report));
  return asked.finally(() => {
    settled = true;
  });
}

/** Counts meshes of a tree's stems. Rejects as `exportWithWorker` does. */
export const countWithWorker = (
  request: CountRequest,
  signal?: AbortSignal,
  spawn: () => WorkerLike = () => spawnWorker(),
): Promise<MeshCount[]> => inWorker(spawn, signal, (service) => service.count(request));

/** Asks a worker that ends with the answer. */
function inWorker<Answer>(
  spawn: () => WorkerLike,
  signal: AbortSignal | undefined,
  ask: (service: Remote<ExportService>) => Promise<Answer>,
): Promise<Answer> {
  if (signal?.aborted) return Promise.reject(signal.reason);
  const worker = spawn();
  const service = remote<ExportService>(worker as Worker);
  return new Promise<Answer>((resolve, reject) => {
    worker.addEventListener('error', (event) => {
      const why = (event as ErrorEvent).message || 'its script did not load';
      reject(new Error(`The worker that writes files stopped: ${why}`));
    });
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    ask(service).then(resolve, reject);
  }).finally(() => worker.terminate());
}
