import type { WebGLRenderer } from 'three';
import { clumpTree } from '../../core/forest/clump-tree.ts';
import { clumpsOf } from '../../core/forest/clumps.ts';
import { cardRadius, pictureClumps } from '../../core/forest/middle-tree.ts';
import type { Vec3 } from '../../core/math/vec3.ts';
import { CARD_PICTURES } from '../../core/pack/card-texel.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { BakePasses } from './bake-passes.ts';
import { type BakeJob, BakeQueue } from './bake-queue.ts';
import { type BakeBox, BakeTree } from './bake-tree.ts';
import { ImpostorAtlas } from './impostor-atlas.ts';

/** Pictures along a side of a layer, and texels of one. */
const SIDE = Math.sqrt(CARD_PICTURES);
const SIZE = 128;

interface Job extends BakeJob {
  taken: number;
}

interface Picture {
  readonly tree: PackedTree;
  readonly direction: Vec3;
  readonly box: BakeBox;
}

/** Bakes the pictures of the clumps of species, four each, into the layers of an atlas; a picture at a time. */
export class ClumpPictures {
  readonly atlas: ImpostorAtlas;
  readonly #passes: BakePasses;
  readonly #tree = new BakeTree();
  readonly #queue = new BakeQueue<Job>((renderer, job) => this.#step(renderer, job));
  #pictures: Picture[] = [];

  /** `layers`: species that there is room for. */
  constructor(layers: number) {
    this.atlas = new ImpostorAtlas({ views: SIDE, size: SIZE, layers });
    this.#passes = new BakePasses(this.atlas);
  }

  /** Part of a picture's side that the clump fills. */
  get filled(): number {
    return this.#passes.filled;
  }

  get idle(): boolean {
    return this.#queue.idle;
  }

  ready(layer: number): boolean {
    return this.#queue.ready(layer);
  }

  /** Asks for a layer to show the clumps of a full tree, in the season that `species` is in (inSeason). */
  bake(layer: number, tree: PackedTree, species: Species): void {
    this.#queue.add({ tree, species, layer, taken: 0 });
  }

  /** Takes pictures for about `ms` milliseconds, one at least where one is left. */
  bakeSome(renderer: WebGLRenderer, ms: number): void {
    this.#queue.work(renderer, ms);
  }

  #step(renderer: WebGLRenderer, job: Job): boolean {
    if (job.taken === 0) this.#pictures = picturesOf(job.tree, job.species);
    const picture = this.#pictures[job.taken];
    if (picture) {
      // Normals are the leaves' own: where a card stands in the crown, it is turned to its outside.
      this.#tree.setTree(picture.tree, job.species, 0);
      this.#tree.draw(renderer, this.#passes.view, picture.direction, picture.box);
      this.#passes.takeView(renderer, job.taken % SIDE, Math.floor(job.taken / SIDE));
      job.taken++;
      return false;
    }
    this.#passes.storeLayer(renderer, job.layer);
    this.#pictures = [];
    this.#tree.leave();
    return true;
  }

  dispose(): void {
    this.#queue.clear();
    this.#passes.dispose();
    this.#tree.dispose();
    this.atlas.dispose();
  }
}

/** The clumps that stand for all of a tree, each as seen from outside of the crown. */
function picturesOf(tree: PackedTree, species: Species): Picture[] {
  const clumps = clumpsOf(tree);
  return pictureClumps(clumps)
    .filter((clump) => clump >= 0)
    .map((clump) => {
      const [x, y, z] = clumps.centre.subarray(3 * clump, 3 * clump + 3) as unknown as Vec3;
      const radius = cardRadius(clumps, clump, tree, species);
      const [dx, dy] = [x - (tree.crown[0] as number), y - (tree.crown[1] as number)];
      const n = Math.hypot(dx, dy, 1e-6) * 1.02;
      return {
        tree: clumpTree(tree, clumps, clump),
        direction: [dx / n, dy / n, Math.sqrt(Math.max(0, 1 - (dx * dx + dy * dy) / (n * n)))],
        box: { centre: [x, y, z], halfWidth: radius, halfHeight: radius, depth: 3 * radius },
      };
    });
}
