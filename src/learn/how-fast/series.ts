import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { syntheticTree } from '../../gpu/crosscheck/synthetic-tree.ts';
import { tiledTree } from '../../gpu/crosscheck/tiled-tree.ts';
import { STEP } from '../../gpu/step.ts';
import { gpuDone } from '../../gpu/timed-rounds.ts';
import { TreeTextures } from '../../gpu/tree-textures.ts';
import { WindPass } from '../../gpu/wind-pass.ts';
import { windSource } from '../../gpu/wind-source.ts';
import { BUNDLE } from '../../view/branch-geometry.ts';
import { deformedMesh } from '../../view/deformed-mesh.ts';
import { strewnPieces } from '../../view/strewn-pieces.ts';
import { shippedWind } from '../tree-stage.ts';
import type { Series, Work } from './run-all.ts';

/** Pixels of what is drawn, much as a window of 2006. */
const SIZE = [1024, 576] as const;
/** A sheet of 4 x 4 vertices a branch: 165 000 vertices are then the 10 000 branches of the paper. */
const SHEET = { sectors: 3, bands: 3, cap: false, bundle: BUNDLE } as const;
const VERTICES = 16;
/** Branches of the tree that larger ones are copies of. */
const TILE = 4096;

const FRAMES = [10_000, 20_000, 41_000, 82_000, 165_000, 335_000, 670_000, 1_340_000] as const;
const STEPS = [4096, 16_384, 65_536, 262_144] as const;

/** The context that all is measured in, and the series. `dispose` gives the context back. */
export function newSeries(): { readonly renderer: WebGLRenderer; readonly series: readonly Series[]; dispose(): void } {
  const renderer = new WebGLRenderer({ canvas: document.createElement('canvas'), antialias: false });
  renderer.setSize(...SIZE, false);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const done = (): Promise<void> => gpuDone(gl);
  const frames = (size: number): Promise<Work> => {
    const camera = new PerspectiveCamera(45, SIZE[0] / SIZE[1], 0.1, 100);
    camera.position.set(0, 0, 16);
    const mesh = deformedMesh(strewnPieces(Math.round(size / VERTICES)), SHEET);
    const scene = new Scene().add(mesh);
    return Promise.resolve({
      run: () => renderer.render(scene, camera),
      done,
      dispose: () => mesh.geometry.dispose(),
    });
  };
  const steps = async (size: number): Promise<Work> => {
    const wind = windSource({ ...(await shippedWind('fresh-breeze')), model: 'direct', pose: 'lagged' });
    const textures = new TreeTextures(tiledTree(syntheticTree(TILE, 7), size / TILE), true);
    const pass = new WindPass(textures);
    let n = 0;
    return {
      run: () => pass.update(renderer, ++n * STEP, wind),
      done,
      dispose() {
        pass.dispose();
        textures.dispose();
      },
    };
  };
  return {
    renderer,
    series: [
      { kind: 'frames', sizes: FRAMES, prepare: frames },
      { kind: 'steps', sizes: STEPS, prepare: steps },
    ],
    dispose() {
      renderer.forceContextLoss();
      renderer.dispose();
    },
  };
}
