import {
  type Box3,
  BufferAttribute,
  type Camera,
  Color,
  DoubleSide,
  InstancedBufferGeometry,
  type IUniform,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  MeshStandardMaterial,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { leafThin, throughColour } from '../../core/look/leaf-look.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { Species } from '../../core/species/species.ts';
import { bundleFor, recount } from '../branch-geometry.ts';
import { inject } from '../inject.ts';
import type { LeafHost } from '../leaf-layer.ts';
import { disposeMaterials, dress, type MaterialSet } from '../tree-materials.ts';
import type { TreeMesh } from '../tree-parts.ts';
import type { ClumpPictures } from './card-bake.ts';
import { CARD_DEPTH, CARD_STANDARD } from './card-shader.ts';
import type { Foliage } from './grove-parts.ts';
import { softenEdges } from './soft-edges.ts';

/** How much larger than its clump a card is drawn: measured, so that as much is covered as by the leaves. */
const GROWN = 1;

/** Alpha above which a texel is drawn; twigs without leaves are thinner than a texel, and filtering takes much of theirs. */
const CUT = 0.5;
const CUT_BARE = 0.4;

/** How wide a clump swings where its leaves flutter as widely as their stalks let them. */
const SWING = 0.18;

/** Clump cards in place of the leaves of a middle tree, or of a grove of them: one draw. */
export class CardLayer implements Foliage {
  readonly #host: LeafHost;
  readonly #uniforms;
  #mesh: TreeMesh | null = null;
  #materials: MaterialSet | null = null;
  #count = 0;
  #fitted = 0;
  #roughness = 0.75;
  #cut = CUT;

  /** `layer`: of the pictures, that of the tree's species; `meanForce` of the wind, metres. */
  constructor(host: LeafHost, pictures: ClumpPictures, layer: number, meanForce: IUniform<number>) {
    this.#host = host;
    const { atlas } = pictures;
    this.#uniforms = {
      cardRange: { value: new Vector2() },
      cardSize: { value: new Vector3(GROWN, 0, 0) },
      cardColours: { value: atlas.colours },
      cardShapes: { value: atlas.shapes },
      cardPictures: { value: new Vector4(layer, atlas.views, pictures.filled, atlas.size) },
      cardThrough: { value: new Color() },
      // Light that a blade lets through, 0 where there are none: such show another side in a gust.
      cardThin: { value: 0 },
      cardMeanForce: meanForce,
      crownRounding: { value: 0.5 },
      levelTint: { value: new Vector4(0, 0, 0, 0) },
    };
  }

  get count(): number {
    return this.#mesh?.visible ? this.#count : 0;
  }

  meshes(): readonly TreeMesh[] {
    return this.#mesh ? [this.#mesh] : [];
  }

  setTree(tree: PackedTree, { foliage, wind }: Species): void {
    this.#count = tree.leafCount;
    this.#fitted = -1;
    const [r, g, b] = throughColour(foliage);
    const thin = foliage.cover > 0 ? leafThin(foliage) : 0;
    this.#uniforms.cardThrough.value.setRGB(r, g, b).multiplyScalar(thin);
    this.#uniforms.cardThin.value = thin;
    this.#uniforms.cardSize.value.y = Math.min(1, (wind.flutter * Math.PI) / 180) * SWING;
    this.#roughness = foliage.roughness;
    this.#cut = foliage.cover > 0 ? CUT : CUT_BARE;
    const set = this.#materials;
    if (!set) return;
    set.standard.roughness = foliage.roughness;
    for (const material of [set.standard, set.depth, set.distance]) material.alphaTest = this.#cut;
  }

  setWind(beats: number): void {
    this.#uniforms.cardSize.value.z = beats;
  }

  fit(_camera: Camera, box: Box3): void {
    const { shown } = this.#host;
    const surfaces = shown.mode !== 'control' && shown.mode !== 'levels';
    const visible = shown.leaves && surfaces && this.#count > 0;
    if (visible && this.#fitted !== this.#count) this.#make(box);
    if (this.#mesh) this.#mesh.visible = visible;
  }

  setWireframe(wireframe: boolean): void {
    if (this.#materials) this.#materials.standard.wireframe = wireframe;
  }

  dropMaterials(): void {
    if (this.#materials) disposeMaterials(this.#materials);
    this.#materials = null;
    this.#fitted = -1;
  }

  dispose(): void {
    this.#mesh?.geometry.dispose();
    this.dropMaterials();
    this.#mesh = null;
  }

  #make(box: Box3): void {
    this.#mesh ??= this.#newMesh();
    const mesh = this.#mesh;
    const bundle = bundleFor(this.#count);
    if (mesh.geometry.userData.bundle !== bundle) {
      mesh.geometry.dispose();
      mesh.geometry = quads(bundle);
    }
    recount(mesh.geometry, this.#count, bundle, box);
    this.#uniforms.cardRange.value.set(this.#count, bundle);
    this.#materials ??= this.#dressed();
    dress(mesh, this.#materials);
    this.#fitted = this.#count;
  }

  #newMesh(): TreeMesh {
    const mesh = this.#host.newMesh('cards');
    softenEdges(mesh);
    return mesh;
  }

  #dressed(): MaterialSet {
    const { shared, shown } = this.#host;
    const defines = this.#host.viewDefines().filter((name) => name !== 'CHANNEL_VIEW');
    const cut = { side: DoubleSide, alphaTest: this.#cut } as const;
    const set: MaterialSet = {
      standard: new MeshStandardMaterial({ ...cut, metalness: 0, roughness: this.#roughness }),
      depth: new MeshDepthMaterial(cut),
      distance: new MeshDistanceMaterial(cut),
    };
    const uniforms = { ...shared, ...this.#uniforms };
    for (const material of [set.standard, set.depth, set.distance]) {
      material.defines = { ...material.defines, ...Object.fromEntries(defines.map((name) => [name, ''])) };
      inject(
        material,
        `windgrove card ${defines.join(' ')}`,
        material === set.standard ? CARD_STANDARD : CARD_DEPTH,
        uniforms,
      );
    }
    set.standard.wireframe = shown.mode === 'wireframe';
    return set;
  }
}

/** `bundle` quads as the mesh of an instance. */
function quads(bundle: number): InstancedBufferGeometry {
  const position = new Float32Array(12 * bundle);
  const index = new Uint16Array(6 * bundle);
  for (let k = 0; k < bundle; k++) {
    position.set([-1, -1, k, 1, -1, k, -1, 1, k, 1, 1, k], 12 * k);
    const v = 4 * k;
    index.set([v, v + 1, v + 2, v + 2, v + 1, v + 3], 6 * k);
  }
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  Object.assign(geometry.userData, { bundle, count: 1, triangles: 2 });
  return geometry;
}
