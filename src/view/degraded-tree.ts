import type { Box3, Camera, Object3D } from 'three';
import { fractions } from '../core/lod/fractions.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import type { channelUniforms } from './channel-look.ts';
import { type DrawnElements, type PaperRange, rangeFor } from './degradation.ts';
import { DegradedLeaves } from './degraded-leaves.ts';
import { DegradedStems } from './degraded-stems.ts';
import type { TreeKit } from './tree-kit.ts';
import type { Shown } from './tree-parts.ts';
import type { BarkUniforms, LeafUniforms, LevelUniforms, SharedUniforms } from './uniforms.ts';

/** What it needs of the tree that it draws. */
export interface DegradedHost {
  readonly kit: TreeKit;
  readonly shown: Shown;
  readonly shared: SharedUniforms;
  readonly bark: BarkUniforms;
  readonly look: LeafUniforms;
  readonly channelLook: ReturnType<typeof channelUniforms>;
  /** Half the picture's height in pixels. */
  readonly lineScale: { value: number };
  viewDefines(): string[];
  /** Makes something a part of the tree, with its shadows. */
  adopt<Part extends Object3D>(part: Part, name: string): Part;
}

/**
 * A tree by Weber & Penn's degradation at range: its geometry stays, and a frame draws prefixes of it, as surfaces and as lines and points.
 *
 * Nothing here is made before it is first drawn.
 */
export class DegradedTree {
  readonly #host: DegradedHost;
  #stems: DegradedStems[] = [];
  #leaves: DegradedLeaves | null = null;
  #made: PackedTree | null = null;

  constructor(host: DegradedHost) {
    this.#host = host;
  }

  /** Draws `tree` for a camera; `levels` are the uniforms of its levels. */
  fit(
    camera: Camera,
    place: { readonly matrixWorld: Object3D['matrixWorld']; readonly box: Box3; readonly pictureHeight: number },
    tree: PackedTree,
    species: Species,
    levels: readonly LevelUniforms[],
    paper: PaperRange,
  ): void {
    this.#make(tree, species, levels, place.box);
    const { shown } = this.#host;
    const r2 = paper.r2 ?? rangeFor(camera, place.matrixWorld, place.box, place.pictureHeight);
    const rules = fractions(r2, { ...paper, eased: true });
    this.#stems.forEach((stems, level) => {
      if (level < shown.levels) stems.fit(rules[stems.item], species, place.pictureHeight / 2);
      else stems.hide();
    });
    if (shown.mode === 'levels') this.#leaves?.hide();
    else this.#leaves?.fit(rules, tree, species);
  }

  hide(): void {
    for (const part of this.#parts()) part.hide();
  }

  /** By the rows of Table 2. */
  drawn(): DrawnElements {
    const sum = (item: DegradedStems['item'], of: (stems: DegradedStems) => number): number =>
      this.#stems.filter((stems) => stems.item === item).reduce((total, stems) => total + of(stems), 0);
    const triangles = (item: DegradedStems['item']): number => sum(item, (s) => (s.tubes.visible ? s.triangles : 0));
    const lines = (item: DegradedStems['item']): number => sum(item, (s) => (s.lines.visible ? s.segments : 0));
    return {
      trunkTriangles: triangles('trunk'),
      trunkLines: lines('trunk'),
      mainTriangles: triangles('main'),
      mainLines: lines('main'),
      otherTriangles: triangles('other'),
      otherLines: lines('other'),
      leafTriangles: this.#leaves?.blades.visible ? this.#leaves.triangles : 0,
      leafPoints: this.#leaves?.points.visible ? this.#leaves.dots : 0,
    };
  }

  /** Triangles, draw calls and leaves of the last frame. */
  stats(): { triangles: number; drawCalls: number; leaves: number } {
    const { trunkTriangles, mainTriangles, otherTriangles, leafTriangles, leafPoints } = this.drawn();
    return {
      triangles: trunkTriangles + mainTriangles + otherTriangles + leafTriangles,
      drawCalls: this.objects().filter(({ visible }) => visible).length,
      leaves: leafPoints,
    };
  }

  /** All that is drawn, or could be. */
  objects(): Object3D[] {
    const leaves = this.#leaves ? [this.#leaves.blades, this.#leaves.points] : [];
    return [...this.#stems.flatMap(({ tubes, lines }) => [tubes, lines]), ...leaves];
  }

  setWireframe(wireframe: boolean): void {
    for (const part of this.#parts()) part.setWireframe(wireframe);
  }

  /** Their programs are others: what is drawn next makes them anew. */
  dropMaterials(): void {
    for (const part of this.#parts()) part.dropMaterials();
  }

  /** Another tree, or other colours, come with the next `fit`. */
  leave(): void {
    this.#made = null;
  }

  dispose(): void {
    for (const part of this.#parts()) part.dispose();
    this.#stems = [];
    this.#leaves = null;
    this.#made = null;
  }

  #parts(): (DegradedStems | DegradedLeaves)[] {
    return this.#leaves ? [...this.#stems, this.#leaves] : this.#stems;
  }

  #make(tree: PackedTree, species: Species, levels: readonly LevelUniforms[], box: Box3): void {
    if (this.#made === tree) return;
    this.#made = tree;
    while (this.#stems.length > levels.length) this.#stems.pop()?.dispose();
    levels.forEach((uniforms, level) => {
      this.#stems[level] ??= new DegradedStems(this.#host, level, uniforms);
      this.#stems[level].setTree(tree, box);
    });
    this.#leaves ??= new DegradedLeaves(this.#host);
    this.#leaves.setTree(tree, species, box);
    this.#leaves.dropMaterials();
  }
}
