import { DEFAULT_FOREST } from '../core/forest/default-forest.ts';
import type { ForestDocument } from '../core/forest/forest.ts';
import { heightAt } from '../core/forest/height-field.ts';
import { forestField } from '../core/forest/terrain.ts';
import { Forest } from '../view/forest/forest.ts';
import { ForestStage } from '../view/forest/forest-stage.ts';
import { loadSpecies, loadWind } from '../view/load.ts';
import { type Bench, SIZE } from './section.ts';

/** Milliseconds after which a forest is measured as it is. */
const PATIENCE = 240_000;

/** A forest of aspens on its ground, seen from its southern edge. */
export class ForestScene {
  readonly stage: ForestStage;
  readonly forest = new Forest({ budget: 1e9 });
  /** The trees are drawn: without them the ground alone is. */
  planted = true;

  constructor(canvas: HTMLCanvasElement) {
    this.stage = new ForestStage(canvas, { antialias: false, preserveDrawingBuffer: true });
    this.stage.resize(...SIZE);
    this.stage.scene.add(this.forest);
    // A step of the budget would be another picture: the finest is held.
    this.forest.holdStep(0);
  }

  /** Plants `count` trees, so densely that each has some eight metres to itself. */
  async plant(count: number): Promise<void> {
    const size = Math.min(2000, Math.max(60, Math.ceil(9 * Math.sqrt(count))));
    const document: ForestDocument = {
      ...DEFAULT_FOREST,
      count,
      size,
      density: { kind: 'clearings', seed: 1, bare: 0, scale: 90 },
      budget: 1e9,
    };
    const field = forestField(document, null);
    const species = new Map([['quaking-aspen', await loadSpecies('species/quaking-aspen.json')]]);
    this.stage.setField(field);
    this.forest.setForest(document, species, field);
    this.forest.setWind(await loadWind('winds/breeze.json'));
    const { camera } = this.stage;
    const y = -0.5 * size + 2;
    camera.position.set(0, heightAt(field, 0, y) + 6, -y);
    camera.lookAt(0, heightAt(field, 0, 0) + 3, 0);
    camera.updateMatrixWorld();
  }

  /** Draws the frame of `time` seconds. */
  draw(time: number): void {
    const { forest, stage } = this;
    forest.visible = this.planted;
    if (this.planted) forest.update(stage.renderer, stage.camera, time, performance.now());
    stage.render();
  }

  /** Grows, bakes and streams, without drawing, until nothing grows any more; false where that takes too long. */
  async settle({ step }: Bench, what: string): Promise<boolean> {
    const from = performance.now();
    while (performance.now() - from < PATIENCE) {
      // A frame of thousands of trees takes seconds on software GL: drawn each time, little else would be done.
      this.forest.update(this.stage.renderer, this.stage.camera, 2, performance.now());
      this.stage.renderer.getContext().finish();
      if (this.forest.settled) return true;
      await step(what);
    }
    return false;
  }

  dispose(): void {
    this.forest.dispose();
    this.stage.renderer.forceContextLoss();
    this.stage.dispose();
  }
}
