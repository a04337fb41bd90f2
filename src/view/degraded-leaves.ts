import {
  type Box3,
  type BufferGeometry,
  type InstancedBufferGeometry,
  Mesh,
  Points,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { leafPrefixes } from '../core/lod/draw-counts.ts';
import type { Fractions } from '../core/lod/fractions.ts';
import { formMesh, formTriangles } from '../core/look/form-mesh.ts';
import { coverCount } from '../core/look/leaf-count.ts';
import { growthWidth, leafGrowth } from '../core/look/leaf-growth.ts';
import type { LeafGrain } from '../core/look/leaf-outline.ts';
import { leafSpecOf } from '../core/look/leaf-spec.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { bundleFor, leafGeometry } from './branch-geometry.ts';
import { bladeMiddle, pointGeometry } from './degraded-geometry.ts';
import { pointMaterials } from './degraded-materials.ts';
import type { DegradedHost } from './degraded-tree.ts';
import { disposeMaterials, dress, leafMaterials, type MaterialSet } from './tree-materials.ts';

/** Triangles of a leaf in the paper's Table 2: a hexagon. */
const PAPER_LEAF = 4;

const viewport = new Vector4();

/** The leaves of a tree at range: the first of them as blades, the first, which are more, as points. */
export class DegradedLeaves {
  readonly blades: Mesh<InstancedBufferGeometry>;
  readonly points: Points<InstancedBufferGeometry>;
  readonly #host: DegradedHost;
  readonly #range = { value: new Vector2() };
  readonly #size = { value: new Vector2(1, 1) };
  readonly #part = { value: new Vector3() };
  readonly #shadowScale = { value: 512 };
  #bladeSet: MaterialSet | null = null;
  #pointSet: MaterialSet | null = null;
  #key = '';
  #trianglesEach = 0;
  #widthOverLength = 1;
  #bundle = 1;
  /** Elements that the last frame drew. */
  triangles = 0;
  dots = 0;

  constructor(host: DegradedHost) {
    this.#host = host;
    this.blades = host.adopt(new Mesh<InstancedBufferGeometry>(), 'leaves at range');
    this.points = host.adopt(new Points<InstancedBufferGeometry>(), 'leaves as points');
    // What a shadow map is as large as, three tells while it draws one.
    this.points.onBeforeShadow = (renderer: WebGLRenderer): void => {
      this.#shadowScale.value = renderer.getCurrentViewport(viewport).w / 2;
    };
  }

  setTree(tree: PackedTree, species: Species, box: Box3): void {
    const spec = leafSpecOf(species);
    const key = [spec.shape, spec.margin, spec.width, spec.petiole, tree.leafCount, box.max.toArray()].join();
    if (key === this.#key) return;
    this.#key = key;
    this.#bundle = bundleFor(tree.leafCount);
    this.#widthOverLength = growthWidth(spec);
    const form = this.#host.kit.leafForm(spec);
    const grain = nearestGrain((g) => formTriangles(form, spec, g));
    const mesh = formMesh(form, spec, grain, this.#bundle, true);
    const one = bladeMiddle(mesh);
    this.#trianglesEach = mesh.trianglesPerCopy;
    this.#part.value.z = one.area;
    this.blades.geometry.dispose();
    this.points.geometry.dispose();
    this.blades.geometry = leafGeometry(mesh, tree.leafCount, this.#bundle, box);
    this.points.geometry = pointGeometry(one, this.#bundle, box);
  }

  /** Draws what the rules leave. */
  fit(rules: Fractions, tree: PackedTree, species: Species): void {
    const { shown } = this.#host;
    const there = coverCount(tree.leafCount, species.foliage);
    const count = shown.leaves ? Math.min(there, shown.leafBudget) : 0;
    const { polygons, points } = leafPrefixes(count, rules);
    this.blades.visible = polygons > 0;
    this.points.visible = points > 0;
    this.triangles = Math.round(polygons) * this.#trianglesEach;
    this.dots = Math.round(points);
    if (count === 0) return;
    const [growX, growY] = leafGrowth(Math.max(polygons, points) / there, this.#widthOverLength);
    const length = tree.leafLength * species.foliage.size;
    this.#size.value.set(growX * length, growY * length);
    this.#part.value.x = polygons;
    this.#part.value.y = points;
    this.#range.value.set(Math.ceil(Math.max(points, polygons)), this.#bundle);
    this.blades.geometry.instanceCount = Math.ceil(polygons / this.#bundle);
    this.points.geometry.instanceCount = Math.ceil(points / this.#bundle);
    if (!this.#bladeSet) this.#dress(species);
  }

  hide(): void {
    this.blades.visible = false;
    this.points.visible = false;
  }

  setWireframe(wireframe: boolean): void {
    if (this.#bladeSet) this.#bladeSet.standard.wireframe = wireframe;
  }

  dropMaterials(): void {
    for (const set of [this.#bladeSet, this.#pointSet]) if (set) disposeMaterials(set);
    this.#bladeSet = null;
    this.#pointSet = null;
  }

  dispose(): void {
    this.dropMaterials();
    for (const drawn of [this.blades, this.points]) {
      (drawn.geometry as BufferGeometry).dispose();
      drawn.removeFromParent();
    }
    this.#key = '';
  }

  #dress({ foliage }: Species): void {
    const { shared, channelLook, look, shown, lineScale } = this.#host;
    const uniforms = {
      ...shared,
      ...channelLook,
      ...look,
      leafRange: this.#range,
      leafSize: this.#size,
      leafPart: this.#part,
      pointScale: lineScale,
    };
    const defines = [...this.#host.viewDefines(), 'LEAF_PARTED'];
    this.#bladeSet = leafMaterials(defines, uniforms);
    this.#bladeSet.standard.roughness = foliage.roughness;
    this.#bladeSet.standard.wireframe = shown.mode === 'wireframe';
    this.#pointSet = pointMaterials([...defines, 'LEAF_POINT'], uniforms, this.#shadowScale, foliage.roughness);
    dress(this.blades, this.#bladeSet);
    this.points.material = this.#pointSet.standard;
    this.points.customDepthMaterial = this.#pointSet.depth;
    this.points.customDistanceMaterial = this.#pointSet.distance;
  }
}

/** The grain from afar whose leaf takes about as many triangles as the paper's. */
function nearestGrain(triangles: (grain: LeafGrain) => number): LeafGrain {
  const off = (grain: LeafGrain): number => Math.abs(triangles(grain) - PAPER_LEAF);
  return off('middle') < off('far') ? 'middle' : 'far';
}
