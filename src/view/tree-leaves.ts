import { type Box3, type Camera, Data3DTexture, LinearFilter, RedFormat, type Vector2 } from 'three';
import { formLight } from '../core/look/form-light.ts';
import { formMesh, formTriangles } from '../core/look/form-mesh.ts';
import type { GroveLight } from '../core/look/grove-light.ts';
import { coverCount, organCount } from '../core/look/leaf-count.ts';
import { growthWidth } from '../core/look/leaf-growth.ts';
import { leafThin } from '../core/look/leaf-look.ts';
import type { LeafGrain } from '../core/look/leaf-outline.ts';
import { leafPoints } from '../core/look/leaf-points.ts';
import { leafSpecOf } from '../core/look/leaf-spec.ts';
import { lobeEnds, VEIN_GROUPS } from '../core/look/leaf-veins.ts';
import { ORGAN_HANG } from '../core/look/organ-hang.ts';

import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import type { Foliage } from './forest/grove-parts.ts';
import { type LeafHost, LeafLayer, type LeafLike } from './leaf-layer.ts';
import type { TreeKit } from './tree-kit.ts';
import type { TreeMesh } from './tree-parts.ts';
import { type LeafUniforms, leafUniforms } from './uniforms.ts';

const GRAINS: readonly LeafGrain[] = ['near', 'middle', 'far'];

const byGrain = (of: (grain: LeafGrain) => number): Record<LeafGrain, number> => {
  const [near, middle, far] = GRAINS.map(of) as [number, number, number];
  return { near, middle, far };
};

/** How much less than the leaves organs answer the wind by themselves. */
const ORGAN_FLUTTER = 0.35;

/** The leaves of one tree, what its twigs bear besides, and the light among them. */
export class TreeLeaves implements Foliage {
  readonly look: LeafUniforms = leafUniforms();
  readonly #organLook: LeafUniforms = { ...leafUniforms(), crownRounding: this.look.crownRounding };
  readonly #host: LeafHost;
  readonly #leaves: LeafLayer;
  readonly #organs: LeafLayer;
  /** What the light was found for. */
  #lit: { of: PackedTree | GroveLight; key: string } | null = null;

  constructor(host: LeafHost) {
    this.#host = host;
    this.#leaves = new LeafLayer(host, 'leaves', this.look, { near: ['LEAF_VEINS'], far: [] });
    const organ = ['LEAF_ORGAN'];
    this.#organs = new LeafLayer(host, 'organs', this.#organLook, { near: organ, far: organ });
  }

  /** The meshes that there are. */
  meshes(): readonly TreeMesh[] {
    return [...this.#leaves.meshes, ...this.#organs.meshes];
  }

  /** Leaves that the last frame drew. */
  get count(): number {
    return this.#leaves.count;
  }

  /** Takes the look of another tree; its geometry is made at the next frame. */
  setTree(tree: PackedTree, species: Species, light?: GroveLight): void {
    this.#setLook(species);
    this.#leaves.take(leavesOf(tree, species, this.#host.kit));
    this.#organs.take(organsOf(tree, species, this.#host.kit));
    this.#light(tree, species, light);
  }

  /** The time in sixteenths of a beat, 0..1, and where the wind blows to at the tree. */
  setWind(beats: number, way: Vector2): void {
    for (const { leafFlutter, leafWind } of [this.look, this.#organLook]) {
      leafFlutter.value.y = beats;
      leafWind.value.copy(way);
    }
  }

  /** Chooses what is drawn for this camera. `box`: bounds of the tree in any wind. */
  fit(camera: Camera, box: Box3): void {
    this.#leaves.fit(camera, box);
    this.#organs.fit(camera, box);
  }

  setWireframe(wireframe: boolean): void {
    this.#leaves.setWireframe(wireframe);
    this.#organs.setWireframe(wireframe);
  }

  /** Their programs are others: what is drawn next makes them anew. */
  dropMaterials(): void {
    this.#leaves.dropMaterials();
    this.#organs.dropMaterials();
  }

  dispose(): void {
    this.#leaves.dispose();
    this.#organs.dispose();
    const { crownLight } = this.#host.shared;
    crownLight.value?.dispose();
    crownLight.value = null;
    this.#lit = null;
  }

  #setLook(species: Species): void {
    const { foliage, organ, wind } = species;
    const { look } = this;
    const form = this.#host.kit.leafForm(leafSpecOf(species));
    const turns = foliage.second !== undefined;
    look.leafColour.value.set(foliage.colour);
    look.leafUnder.value.set(foliage.under);
    look.leafGlow.value.set(foliage.glow);
    look.leafSecond.value.set(foliage.second ?? foliage.colour);
    look.leafTurned.value = turns ? foliage.secondShare : 0;
    look.leafVariation.value = foliage.variation;
    look.leafThin.value = leafThin(foliage);
    look.leafVeins.value.set(foliage.veins, VEIN_GROUPS.indexOf(form.veins));
    lobeEnds(form).forEach(([x, z], i) => {
      look.leafLobes.value[i]?.set(x, z);
    });
    look.leafFlutter.value.x = (wind.flutter * Math.PI) / 180;
    const other = this.#organLook;
    other.leafColour.value.set(organ.colour);
    other.leafUnder.value.set(organ.second);
    other.leafGlow.value.set(organ.colour);
    other.leafSecond.value.set(organ.colour);
    other.leafVariation.value = organ.kind === 'blossom' ? 0.1 : 0.3;
    other.leafThin.value = organ.kind === 'blossom' ? 1.1 : 0;
    other.leafHang.value = ORGAN_HANG[organ.kind];
    other.leafFlutter.value.x = look.leafFlutter.value.x * ORGAN_FLUTTER;
  }

  /** Finds the light inside the crown anew where leaves are elsewhere or others. */
  #light(tree: PackedTree, species: Species, given?: GroveLight): void {
    const { foliage, leaves } = species;
    const key = [foliage.cover, foliage.size, foliage.outline, foliage.margin, leaves.shape, leaves.scaleX].join();
    const of = given ?? tree;
    if (this.#lit?.of === of && this.#lit.key === key) return;
    this.#lit = { of, key };
    const { crownLight, crownLow, crownSize } = this.#host.shared;
    const { cells, low, size, data } = given ?? formLight(tree, species, this.#host.kit.leafForm(leafSpecOf(species)));
    crownLight.value?.dispose();
    const texture = new Data3DTexture(data, cells, cells, cells);
    texture.name = 'light in the crown';
    texture.format = RedFormat;
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearFilter;
    texture.unpackAlignment = 1;
    texture.needsUpdate = true;
    crownLight.value = texture;
    crownLow.value.set(...low);
    crownSize.value.set(...size);
  }
}

/** Some way off a petiole is a fraction of a pixel wide, and a third of a leaf's vertices. */
const sessile = (grain: LeafGrain): boolean => grain !== 'near';

function leavesOf(tree: PackedTree, species: Species, kit: TreeKit): LeafLike {
  const { foliage } = species;
  const spec = leafSpecOf(species);
  const form = kit.leafForm(spec);
  return {
    key: String([spec.shape, spec.margin, spec.width, spec.petiole]),
    mesh: (grain, bundle) => formMesh(form, spec, grain, bundle, sessile(grain)),
    triangles: byGrain((grain) => formTriangles(form, spec, grain, sessile(grain))),
    count: coverCount(tree.leafCount, foliage),
    length: tree.leafLength * foliage.size,
    widthOverLength: growthWidth(spec),
    roughness: foliage.roughness,
    points: () => leafPoints(tree, tree.leafCount),
  };
}

function organsOf(tree: PackedTree, { organ }: Species, kit: TreeKit): LeafLike {
  const { kind } = organ;
  return {
    key: kind,
    mesh: (grain, bundle) => kit.organMesh(kind, grain, bundle),
    // Blossoms stand in threes, and most of a body faces away: a third of its triangles share the pixels of its length.
    triangles: byGrain((grain) => (kind === 'none' ? 0 : kit.organMesh(kind, grain, 1).trianglesPerCopy / 3)),
    count: organCount(tree.leafCount, organ),
    length: organ.size,
    widthOverLength: 1,
    roughness: kind === 'fruit' ? 0.35 : 0.75,
    points: () => leafPoints(tree, tree.leafCount),
  };
}
