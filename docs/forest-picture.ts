// The page that docs/make-forest-picture.ts takes its picture from: a forest at one moment, in full detail however long that takes.
import { forestDensity } from '../src/core/forest/density.ts';
import type { ForestDocument } from '../src/core/forest/forest.ts';
import { forestWind } from '../src/core/forest/forest-wind.ts';
import { heightAt } from '../src/core/forest/height-field.ts';
import { scatter } from '../src/core/forest/scatter.ts';
import { forestField } from '../src/core/forest/terrain.ts';
import { Forest } from '../src/view/forest/forest.ts';
import { ForestStage } from '../src/view/forest/forest-stage.ts';
import { loadSpecies, loadWind } from '../src/view/load.ts';

export interface ForestJob {
  readonly document: ForestDocument;
  /** Metres of the eye above the ground under it, in place of the camera's own height. */
  readonly above?: number;
  readonly width: number;
  readonly height: number;
  /** Pixels drawn to each of the picture along a side. */
  readonly fine: number;
  /** Degrees that the height of the picture shows. */
  readonly fov: number;
  /** Seconds of the clock. */
  readonly time: number;
  /** Shapes that a species has at most. */
  readonly variants: number;
}

/** Seconds that the wind has blown by then, and steps a second: springs must have swung in. */
const BLOWN = 3;
const STEPS = 20;

async function picture({
  document: forest,
  width,
  height,
  fine,
  fov,
  time,
  variants,
  above,
}: ForestJob): Promise<string> {
  const canvas = document.querySelector('canvas')!;
  const stage = new ForestStage(canvas, { antialias: true, preserveDrawingBuffer: true });
  const trees = new Forest({ variants });
  trees.holdStep(0);
  trees.crossFade = 0;
  stage.scene.add(trees);
  stage.resize(width, height, fine);
  const ids = forest.mix.map(({ species }) => species);
  const species = new Map(
    await Promise.all(ids.map(async (id) => [id, await loadSpecies(`/species/${id}.json`)] as const)),
  );
  const field = forestField(forest, null);
  stage.setField(field);
  stage.setScene(forest.stage, forest.hour, forest.season);
  trees.setWind(forestWind(await loadWind(`/winds/${forest.wind}.json`), forest.windSpeed, forest.windTurn));
  trees.setForest(forest, species, field, scatter(forest, field, forestDensity(forest, null)));
  const { camera, renderer } = stage;
  const { x, y, z, yaw, pitch } = forest.camera!;
  camera.fov = fov;
  camera.updateProjectionMatrix();
  camera.position.set(x, above === undefined ? z : heightAt(field, x, y) + above, -y);
  camera.rotation.set((pitch * Math.PI) / 180, ((yaw - 90) * Math.PI) / 180, 0, 'YXZ');
  camera.updateMatrixWorld();
  let now = 0;
  const go = (at: number): void => {
    now += 50;
    trees.update(renderer, camera, at, now);
  };
  do {
    go(time - BLOWN);
    // What the worker has sent comes in between.
    await new Promise((resolve) => setTimeout(resolve));
  } while (!trees.settled);
  for (let step = 1; step <= BLOWN * STEPS; step++) go(time - BLOWN + step / STEPS);
  stage.setTrees(trees.crowns(), trees.litter);
  stage.blow(trees.windSource(), time, trees.meanForce);
  stage.render();
  return canvas.toDataURL('image/png');
}

Object.assign(window, { windgroveForestPicture: picture });
