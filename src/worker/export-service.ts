import type { ExportFile, ExportOptions } from '../core/io/export-options.ts';
import type { ExportStage } from '../core/io/export-tree.ts';
import type { BarkMeshOptions } from '../core/mesh/bark-mesh.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { handOver } from './remote.ts';

/** What the page asks of the worker. */
export interface ExportRequest {
  readonly species: Species;
  readonly seed: number;
  readonly wind: Wind;
  readonly options: ExportOptions;
}

/** How far it is: what it is at, and the part of all of it that is done, 0..1. */
export interface ExportProgress {
  readonly stage: ExportStage;
  readonly done: number;
}

/** A tree whose meshes are to be counted. */
export interface CountRequest {
  readonly species: Species;
  readonly seed: number;
  readonly meshes: readonly BarkMeshOptions[];
}

/** What a mesh of the stems has. */
export interface MeshCount {
  readonly vertices: number;
  readonly triangles: number;
}

/** The worker's side. */
export interface ExportService {
  write(request: ExportRequest, progress?: (progress: ExportProgress) => void): Promise<ExportFile[]>;
  /** Counts the meshes of the stems, in the order of the request. */
  count(request: CountRequest): Promise<MeshCount[]>;
}

/** Least part of the whole between two messages of one stage: a message costs more than a stem. */
const STEP = 0.01;

/** What the worker offers; apart from the worker's script so that a test can hold it at the end of any channel. */
export const exportService: ExportService = {
  async write({ species, seed, wind, options }, progress) {
    const { exportTree } = await import('../core/io/export-tree.ts');
    let last: ExportProgress | undefined;
    const files = await exportTree(species, seed, wind, options, (stage, done) => {
      if (!progress || (last && last.stage === stage && done - last.done < STEP && done < 1)) return;
      last = { stage, done };
      progress(last);
    });
    return handOver(files, [...new Set(files.map(({ bytes }) => bytes.buffer))]);
  },
  async count({ species, seed, meshes }) {
    const [{ growPacked }, { meshBark }] = await Promise.all([
      import('../core/pack/grow-packed.ts'),
      import('../core/mesh/bark-mesh.ts'),
    ]);
    const grown = growPacked(species, seed);
    return meshes.map((options) => {
      // Stems that 32 bits cannot hold fall out while they are written: a plan would count them.
      const { vertexCount, triangleCount } = meshBark(grown, options);
      return { vertices: vertexCount, triangles: triangleCount };
    });
  },
};
