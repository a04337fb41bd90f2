import type { WebGLRenderer } from 'three';
import { crownDensity } from '../../core/forest/crown-density.ts';
import { LEAF_REACH } from '../../core/forest/middle-tree.ts';
import { viewDirection } from '../../core/forest/octahedral.ts';
import { viewExtent } from '../../core/forest/view-extent.ts';
import { leafThin, throughColour } from '../../core/look/leaf-look.ts';
import { leafPoints } from '../../core/look/leaf-points.ts';
import { MECHANICS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { PassState } from '../../gpu/pass-state.ts';
import { BakePasses } from './bake-passes.ts';
import { type BakeBox, BakeTree } from './bake-tree.ts';
import type { ImpostorAtlas, LayerFacts } from './impostor-atlas.ts';

interface Job {
  readonly tree: PackedTree;
  readonly species: Species;
  readonly layer: number;
  readonly box: BakeBox;
  /** Views that are taken already. */
  taken: number;
  ms: number;
}

/** How far a leaf of the crown's normal is turned outside: as WindTree has it. */
const ROUNDING = 0.5;

/** Bakes trees into the layers of an atlas, a view at a time. */
export class ImpostorBaker {
  readonly atlas: ImpostorAtlas;
  readonly #passes: BakePasses;
  readonly #tree = new BakeTree();
  readonly #state = new PassState();
  readonly #ready: boolean[] = [];
  #jobs: Job[] = [];
  #current: Job | null = null;
  /** Milliseconds of script that the last layer took, all its views together. */
  lastMs = 0;

  constructor(atlas: ImpostorAtlas) {
    this.atlas = atlas;
    this.#passes = new BakePasses(atlas);
  }

  /** Is everything that was asked for baked? */
  get idle(): boolean {
    return this.#jobs.length === 0;
  }

  /** Can the layer be drawn? */
  ready(layer: number): boolean {
    return this.#ready[layer] === true;
  }

  /** Asks for a layer to show a full tree at rest, in the season that `species` is in (inSeason). A layer that is ready stays so meanwhile. */
  bake(layer: number, tree: PackedTree, species: Species): void {
    const { centre, halfWidth, radius } = viewExtent(tree, LEAF_REACH * tree.leafLength * species.foliage.size);
    const fill = this.#passes.filled;
    const box = { centre, halfWidth, halfHeight: radius, depth: radius };
    this.#jobs = this.#jobs.filter((job) => job.layer !== layer);
    if (this.#current?.layer === layer) this.#current = null;
    this.#jobs.push({ tree, species, layer, box, taken: 0, ms: 0 });
    this.atlas.setFacts(layer, factsOf(tree, species, box, fill));
  }

  /** Takes views for about `ms` milliseconds, one at least where one is left; true when all is done. */
  bakeSome(renderer: WebGLRenderer, ms: number): boolean {
    const began = performance.now();
    if (this.#jobs.length === 0) return true;
    this.#state.begin(renderer);
    do this.#step(renderer);
    while (this.#jobs.length > 0 && performance.now() - began < ms);
    this.#state.end(renderer);
    return this.#jobs.length === 0;
  }

  #step(renderer: WebGLRenderer): void {
    const job = this.#jobs[0] as Job;
    const began = performance.now();
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
    } else {
      this.#passes.storeLayer(renderer, job.layer);
      this.#ready[job.layer] = true;
      this.#jobs.shift();
      this.#current = null;
      this.#tree.leave();
      this.lastMs = job.ms;
    }
    job.ms += performance.now() - began;
  }

  dispose(): void {
    this.#jobs = [];
    this.#passes.dispose();
    this.#tree.dispose();
  }
}

/** What the drawing of a layer needs to know; `fill`: the part of a cell that the box fills. */
function factsOf(tree: PackedTree, species: Species, box: BakeBox, fill: number): LayerFacts {
  const { bounds, crown, mechanics } = tree;
  const height = (bounds[5] as number) - Math.min(0, bounds[2] as number);
  const length = mechanics[MECHANICS.LENGTH] ?? height;
  const flexible = mechanics[MECHANICS.FLEXIBILITY] ?? 0;
  const feet = Array.from(leafPoints(tree, 400)).filter((_, i) => i % 3 === 2);
  feet.sort((a, b) => a - b);
  const thin = leafThin(species.foliage);
  const [r, g, b] = throughColour(species.foliage).map((c) => c * thin) as [number, number, number];
  return {
    centre: box.centre,
    halfWidth: box.halfWidth / fill,
    halfHeight: box.halfHeight / fill,
    height,
    // The bend of a stem grows as s^1.8 along it and with its length's 0.6th part (shaders/wind/bend.glsl): summed up.
    give: (flexible * length ** 0.4 * 3 ** 0.6) / 2.8,
    density: crownDensity(tree, species),
    crown,
    leafLow: species.foliage.cover > 0 && feet.length > 0 ? (feet[Math.floor(feet.length * 0.03)] as number) : 1e6,
    through: [r, g, b],
    roughness: species.foliage.roughness,
  };
}
