import type { WebGLRenderer } from 'three';
import { crownDensity } from '../../core/forest/crown-density.ts';
import { crownGive } from '../../core/forest/crown-give.ts';
import { LEAF_REACH } from '../../core/forest/middle-tree.ts';
import { viewDirection } from '../../core/forest/octahedral.ts';
import { viewExtent } from '../../core/forest/view-extent.ts';
import { leafThin, throughColour } from '../../core/look/leaf-look.ts';
import { leafPoints } from '../../core/look/leaf-points.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { BakePasses } from './bake-passes.ts';
import { type BakeJob, BakeQueue } from './bake-queue.ts';
import { type BakeBox, BakeTree } from './bake-tree.ts';
import type { ImpostorAtlas, LayerFacts } from './impostor-atlas.ts';

interface Job extends BakeJob {
  readonly box: BakeBox;
  /** Views that are taken already. */
  taken: number;
}

/** How far a leaf of the crown's normal is turned outside: as WindTree has it. */
const ROUNDING = 0.5;

/** Bakes trees into the layers of an atlas, a view at a time. */
export class ImpostorBaker {
  readonly atlas: ImpostorAtlas;
  readonly #passes: BakePasses;
  readonly #tree = new BakeTree();
  readonly #queue = new BakeQueue<Job>((renderer, job) => this.#step(renderer, job));
  #current: Job | null = null;

  constructor(atlas: ImpostorAtlas) {
    this.atlas = atlas;
    this.#passes = new BakePasses(atlas);
  }

  get idle(): boolean {
    return this.#queue.idle;
  }

  ready(layer: number): boolean {
    return this.#queue.ready(layer);
  }

  /** Asks for a layer to show a full tree at rest, in the season that `species` is in (inSeason). */
  bake(layer: number, tree: PackedTree, species: Species): void {
    const { centre, halfWidth, radius } = viewExtent(tree, LEAF_REACH * tree.leafLength * species.foliage.size);
    const fill = this.#passes.filled;
    const box = { centre, halfWidth, halfHeight: radius, depth: radius };
    this.#queue.add({ tree, species, layer, box, taken: 0 });
    this.atlas.setFacts(layer, factsOf(tree, species, box, fill));
  }

  /** Takes views for about `ms` milliseconds, one at least where one is left. */
  bakeSome(renderer: WebGLRenderer, ms: number): void {
    this.#queue.work(renderer, ms);
  }

  #step(renderer: WebGLRenderer, job: Job): boolean {
    if (this.#current !== job) {
      this.#tree.setTree(job.tree, job.species, ROUNDING);
      this.#current = job;
      job.taken = 0;
    }
    const { views } = this.atlas;
    if (job.taken < views * views) {
      const [i, j] = [job.taken % views, Math.floor(job.taken / views)];
      this.#tree.draw(renderer, this.#passes.view, viewDirection(i, j, views), job.box);
      this.#passes.takeView(renderer, i, j);
      job.taken++;
      return false;
    }
    this.#passes.storeLayer(renderer, job.layer);
    this.#current = null;
    this.#tree.leave();
    return true;
  }

  dispose(): void {
    this.#queue.clear();
    this.#passes.dispose();
    this.#tree.dispose();
  }
}

/** What the drawing of a layer needs to know; `fill`: the part of a cell that the box fills. */
function factsOf(tree: PackedTree, species: Species, box: BakeBox, fill: number): LayerFacts {
  const { bounds, crown } = tree;
  const height = (bounds[5] as number) - Math.min(0, bounds[2] as number);
  const feet = Array.from(leafPoints(tree, 400)).filter((_, i) => i % 3 === 2);
  feet.sort((a, b) => a - b);
  const thin = leafThin(species.foliage);
  const [r, g, b] = throughColour(species.foliage).map((c) => c * thin) as [number, number, number];
  return {
    centre: box.centre,
    halfWidth: box.halfWidth / fill,
    halfHeight: box.halfHeight / fill,
    height,
    give: crownGive(tree, height),
    density: crownDensity(tree, species),
    crown,
    // Bare twigs are as many and as unlike as leaves; but no light comes through them.
    leafLow: feet.length > 0 ? (feet[Math.floor(feet.length * 0.03)] as number) : 1e6,
    through: species.foliage.cover > 0 ? [r, g, b] : [0, 0, 0],
    roughness: species.foliage.roughness,
    thin: species.foliage.cover > 0 ? thin : 0,
  };
}
