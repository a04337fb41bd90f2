import { type Box3, type InstancedBufferGeometry, LineSegments, Mesh, type MeshStandardMaterial, Vector3 } from 'three';
import { itemOf, partSums, prefixOf, STEM_FORM } from '../core/lod/draw-counts.ts';
import type { Fraction } from '../core/lod/fractions.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { branchGeometry, bundleFor } from './branch-geometry.ts';
import { lineGeometry } from './degraded-geometry.ts';
import { lineMaterial } from './degraded-materials.ts';
import type { DegradedHost } from './degraded-tree.ts';
import { stemDefines } from './stem-defines.ts';
import { branchMaterials, disposeMaterials, dress, type MaterialSet } from './tree-materials.ts';
import type { LevelUniforms } from './uniforms.ts';

/** The stems of one level at range: the first of them as tubes, the first, which are more, as lines. */
export class DegradedStems {
  readonly tubes: Mesh<InstancedBufferGeometry>;
  readonly lines: LineSegments<InstancedBufferGeometry, MeshStandardMaterial>;
  readonly #host: DegradedHost;
  readonly #level: number;
  readonly #shape: LevelUniforms;
  /** Shared by both, since both are of the same places; what is cut is their own. */
  readonly #range = { value: new Vector3() };
  readonly #tubePart = { value: new Vector3() };
  readonly #linePart = { value: new Vector3() };
  #tubeSums: Uint32Array = new Uint32Array(1);
  #lineSums: Uint32Array = new Uint32Array(1);
  #set: MaterialSet | null = null;
  #dressed = false;
  #bundle = 0;
  /** Elements that the last frame drew. */
  triangles = 0;
  segments = 0;

  /** `shape`: the uniforms of the level that do not depend on what is drawn of it. */
  constructor(host: DegradedHost, level: number, shape: LevelUniforms) {
    this.#host = host;
    this.#level = level;
    this.#shape = shape;
    this.tubes = host.adopt(new Mesh<InstancedBufferGeometry>(), `level ${level} at range`);
    this.lines = host.adopt(
      new LineSegments<InstancedBufferGeometry, MeshStandardMaterial>(),
      `lines of level ${level}`,
    );
    this.lines.castShadow = false;
  }

  /** Which of the paper's descriptions it is. */
  get item(): ReturnType<typeof itemOf> {
    return itemOf(this.#level);
  }

  setTree(tree: PackedTree, box: Box3): void {
    const { lines, bands, sectors } = STEM_FORM[this.item];
    const { start, count } = tree.levels[this.#level] ?? { start: 0, count: 0 };
    this.#bundle = bundleFor(count);
    this.#range.value.set(start, count, this.#bundle);
    this.#tubeSums = partSums(tree, this.#level, bands);
    this.#lineSums = partSums(tree, this.#level, lines);
    this.#tubePart.value.set(0, bands, bands);
    this.#linePart.value.set(0, lines, lines);
    this.tubes.geometry.dispose();
    this.lines.geometry.dispose();
    this.tubes.geometry = branchGeometry({ sectors, bands, cap: false, bundle: this.#bundle }, count, box);
    this.lines.geometry = lineGeometry(lines, this.#bundle, box);
    this.dropMaterials();
  }

  /** Draws what a fraction leaves. */
  fit({ polygons, thin }: Fraction, species: Species, scale: number): void {
    const tubes = prefixOf(this.#tubeSums, polygons);
    const lines = prefixOf(this.#lineSums, thin);
    this.#tubePart.value.x = tubes.cut;
    this.#linePart.value.x = lines.cut;
    this.tubes.geometry.instanceCount = Math.ceil(Math.ceil(tubes.cut) / this.#bundle);
    this.lines.geometry.instanceCount = Math.ceil(Math.ceil(lines.cut) / this.#bundle);
    this.tubes.visible = tubes.cut > 0;
    this.lines.visible = lines.cut > 0;
    this.triangles = tubes.elements * STEM_FORM[this.item].sectors * 2;
    this.segments = lines.elements;
    this.#host.lineScale.value = scale;
    if (!this.#dressed) this.#dress(species);
  }

  hide(): void {
    this.tubes.visible = false;
    this.lines.visible = false;
  }

  setWireframe(wireframe: boolean): void {
    if (this.#set) this.#set.standard.wireframe = wireframe;
  }

  dropMaterials(): void {
    if (this.#set) disposeMaterials(this.#set);
    if (this.#dressed) this.lines.material.dispose();
    this.#set = null;
    this.#dressed = false;
  }

  dispose(): void {
    this.dropMaterials();
    for (const drawn of [this.tubes, this.lines]) {
      drawn.geometry.dispose();
      drawn.removeFromParent();
    }
  }

  #dress(species: Species): void {
    const { shared, bark, channelLook, shown, lineScale } = this.#host;
    const view = [...this.#host.viewDefines(), 'PARTED'];
    const uniforms = { ...shared, ...bark, ...channelLook, ...this.#shape, branchRange: this.#range };
    this.#set = branchMaterials([...stemDefines(this.#level, species, false), ...view], {
      ...uniforms,
      branchPart: this.#tubePart,
    });
    this.#set.standard.roughness = species.bark.roughness;
    this.#set.standard.wireframe = shown.mode === 'wireframe';
    dress(this.tubes, this.#set);
    this.lines.material = lineMaterial(
      [...stemDefines(this.#level, species, false, 'ribbon'), ...view],
      { ...uniforms, branchPart: this.#linePart, lineScale },
      species.bark.roughness,
    );
    this.#dressed = true;
  }
}
