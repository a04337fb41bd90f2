import { describe, expect, it } from 'vitest';
import { DEFAULT_EXPORT, type ExportOptions } from '../../src/core/io/export-options.ts';
import { exportTree } from '../../src/core/io/export-tree.ts';
import { STILL } from '../../src/core/wind/wind.ts';
import { type ExportProgress, exportWithWorker } from '../../src/worker/export-client.ts';
import { exportService } from '../../src/worker/export-service.ts';
import { SMALL } from '../core/mesh/small-trees.ts';
import { FakeWorker } from './fake-worker.ts';

const glb: ExportOptions = { ...DEFAULT_EXPORT, textures: 'none', clip: true, seconds: 1 };

/** A service that never answers. */
const asleep = { write: () => new Promise(() => {}) };

describe('an export in a worker', () => {
  it('makes the files that it makes here, and ends', async () => {
    const worker = new FakeWorker(exportService);
    const files = await exportWithWorker(SMALL.aspen, 3, STILL, glb, {}, () => worker);
    expect(files).toEqual(await exportTree(SMALL.aspen, 3, STILL, glb));
    expect(files.map(({ name, type }) => [name, type])).toEqual([['quaking-aspen-3.glb', 'model/gltf-binary']]);
    expect(worker.terminated).toBe(true);
  });

  it('tells what it is at and how far it is, from nothing to all', async () => {
    const told: ExportProgress[] = [];
    await exportService.write({ species: SMALL.aspen, seed: 3, wind: STILL, options: glb }, (p) => told.push(p));
    const done = told.map((p) => p.done);
    expect(done).toEqual([...done].sort((a, b) => a - b));
    expect(new Set(told.map((p) => p.stage))).toEqual(new Set(['grow', 'textures', 'mesh', 'wind', 'write']));
    expect(done[0]).toBe(0);
    expect(done.at(-1)).toBe(1);
  });

  it('hands on what it is told while it works, and nothing afterwards', async () => {
    let late: ((progress: ExportProgress) => void) | undefined;
    const worker = new FakeWorker({
      write: async (_: unknown, progress: (p: ExportProgress) => Promise<void>) => {
        late = progress;
        await progress({ stage: 'grow', done: 0.1 });
        await progress({ stage: 'mesh', done: 0.5 });
        return [];
      },
    });
    const told: number[] = [];
    await exportWithWorker(SMALL.aspen, 3, STILL, glb, { onProgress: ({ done }) => told.push(done) }, () => worker);
    expect(told).toEqual([0.1, 0.5]);
    await late?.({ stage: 'write', done: 1 });
    expect(told).toEqual([0.1, 0.5]);
  });

  it('stops at once when it is called off', async () => {
    const worker = new FakeWorker(asleep);
    const control = new AbortController();
    const asked = exportWithWorker(SMALL.aspen, 1, STILL, glb, { signal: control.signal }, () => worker);
    control.abort();
    await expect(asked).rejects.toMatchObject({ name: 'AbortError' });
    expect(worker.terminated).toBe(true);
  });

  it('starts nothing that was called off before', async () => {
    const spawn = () => {
      throw new Error('spawned');
    };
    const asked = exportWithWorker(SMALL.aspen, 1, STILL, glb, { signal: AbortSignal.abort() }, spawn);
    await expect(asked).rejects.toMatchObject({ name: 'AbortError' });
  });

  it('hands on what went wrong there, and that its script failed', async () => {
    const broken = new FakeWorker({
      write: () => {
        throw new RangeError('too many bones');
      },
    });
    await expect(exportWithWorker(SMALL.aspen, 1, STILL, glb, {}, () => broken)).rejects.toThrow('too many bones');
    expect(broken.terminated).toBe(true);
    const dead = new FakeWorker(asleep);
    const asked = exportWithWorker(SMALL.aspen, 1, STILL, glb, {}, () => dead);
    dead.fail('out of memory');
    await expect(asked).rejects.toThrow('out of memory');
    expect(dead.terminated).toBe(true);
  });
});
