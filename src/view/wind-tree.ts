import { type Intersection, Matrix4, Object3D, Ray, type Raycaster, Vector2, type WebGLRenderer } from 'three';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import { capabilitiesOf } from '../gpu/capabilities.ts';
import { CpuPoser } from '../gpu/cpu-poser.ts';
import type { Poser } from '../gpu/poser.ts';
import { TreeTextures } from '../gpu/tree-textures.ts';
import { WindPass } from '../gpu/wind-pass.ts';
import { type Detail, LEAF_BUDGET } from './detail.ts';
import { FeltWind } from './felt-wind.ts';
import { pickBranch, pickCrown } from './pick.ts';
import { windBox } from './tree-extent.ts';
import { type Mode, TreeParts } from './tree-parts.ts';

export type { Mode } from './tree-parts.ts';

/** How a tree is drawn. */
export interface WindTreeOptions {
  /** `auto` (default) goes by size on screen. */
  detail?: Detail;
  /** Leaves drawn at most; the rest is left out evenly and the others grow to cover as much. */
  leafBudget?: number;
}

/**
 * A tree in the wind, at home in any three.js scene: standard lights, shadows, fog, environment maps, clipping.
 *
 * Give it a packed tree and a wind, and call `update` once a frame before rendering. Metres; y is up outside. Several trees
 * may share a scene; each feels the wind at the place where it stands.
 */
export class WindTree extends Object3D {
  readonly isWindTree = true;
  readonly #parts: TreeParts;
  readonly #felt = new FeltWind();
  #tree: PackedTree | null = null;
  #species: Species | null = null;
  #textures: TreeTextures | null = null;
  #poser: Poser | null = null;
  #time = 0;
  #leaves: boolean | 'auto' = 'auto';
  #levels = Number.POSITIVE_INFINITY;
  readonly #size = new Vector2();

  constructor({ detail = 'auto', leafBudget = LEAF_BUDGET[detail] }: WindTreeOptions = {}) {
    super();
    this.name = 'wind tree';
    this.#parts = new TreeParts({ mode: 'shaded', levels: Number.POSITIVE_INFINITY, leaves: true, detail, leafBudget });
    this.#parts.visible = false;
    this.add(this.#parts);
  }

  /** Takes a tree; the old one goes. What is drawn changes with the next `update`. */
  setTree(packed: PackedTree, species: Species): void {
    this.#dropTextures();
    this.#tree = packed;
    this.#species = species;
    this.#parts.setTree(packed, species);
    this.#show();
  }

  /** Lets a wind blow, fading over from the last one in `fade` seconds of the clock (default: at once). */
  setWind(wind: Wind, { fade = 0 }: { fade?: number } = {}): void {
    this.#felt.set(wind, this.#time, fade);
  }

  /** The wind that blows or is fading in. */
  get wind(): Wind {
    return this.#felt.wind;
  }

  /** Poses the tree as of `time` seconds: runs the wind pass, or the CPU reference where the GPU lacks float targets. */
  update(renderer: WebGLRenderer, time: number): void {
    const species = this.#species;
    if (!this.#tree || !species) return;
    this.#time = time;
    const { textures, poser } = this.#prepare(renderer, this.#tree);
    this.updateWorldMatrix(true, false);
    this.#felt.moveTo(this.matrixWorld);
    poser.update(renderer, time, this.#felt);
    const { shared, leafLook } = this.#parts;
    shared.poseEven.value = textures.uniforms.poseEven.value;
    shared.poseOdd.value = textures.uniforms.poseOdd.value;
    this.#parts.setPaper(this.#felt.wind.paper);
    // Every leaf beats a whole number of times in sixteen beats, so this may wrap (shaders/leaf/vertex.glsl).
    const beats = (time * species.wind.flutterRate) / 16;
    leafLook.leafFlutter.value.y = beats - Math.floor(beats);
    this.#parts.pictureHeight = renderer.getDrawingBufferSize(this.#size).y;
    this.#parts.visible = true;
  }

  /** Levels below this one are drawn; all by default. */
  get levelsShown(): number {
    return this.#levels;
  }

  set levelsShown(levels: number) {
    this.#levels = levels;
    this.#show();
  }

  /** Whether leaves are drawn; `auto`, the default: when all levels are. */
  get showLeaves(): boolean | 'auto' {
    return this.#leaves;
  }

  set showLeaves(leaves: boolean | 'auto') {
    this.#leaves = leaves;
    this.#show();
  }

  get mode(): Mode {
    return this.#parts.shown.mode;
  }

  set mode(mode: Mode) {
    this.#parts.shown.mode = mode;
    this.#parts.applyMode();
  }

  get detail(): Detail {
    return this.#parts.shown.detail;
  }

  set detail(detail: Detail) {
    this.#parts.shown.detail = detail;
  }

  get leafBudget(): number {
    return this.#parts.shown.leafBudget;
  }

  set leafBudget(leaves: number) {
    this.#parts.shown.leafBudget = leaves;
  }

  /** How far the normals of the leaves turn towards the outside of the crown, 0..1. */
  get crownRounding(): number {
    return this.#parts.leafLook.crownRounding.value;
  }

  set crownRounding(amount: number) {
    this.#parts.leafLook.crownRounding.value = amount;
  }

  /** Sets both for every part of the tree. */
  setShadows(cast: boolean, receive: boolean): void {
    this.#parts.setShadows(cast, receive);
  }

  /** What the last frame drew. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number; bytes: number } {
    return { ...this.#parts.stats(), bytes: this.#textures?.bytes ?? 0 };
  }

  /** The pose as last computed, laid out as `PackedTree.restPose.data`; null before the first `update`. Slow. */
  readPose(renderer: WebGLRenderer): Float32Array | null {
    return this.#poser?.read(renderer) ?? null;
  }

  /** Answers with the branch that the ray meets at rest, else with the crown as an ellipsoid. */
  override raycast(raycaster: Raycaster, intersects: Intersection[]): void {
    const tree = this.#tree;
    if (!tree) return;
    const { matrixWorld } = this.#parts;
    const ray = new Ray().copy(raycaster.ray).applyMatrix4(new Matrix4().copy(matrixWorld).invert());
    const box = windBox(tree.bounds);
    if (!ray.intersectsBox(box)) return;
    const places = tree.levels
      .slice(0, this.#levels)
      .reduce((end, { start, count }) => Math.max(end, start + count), 0);
    const branch = pickBranch(tree, ray, places);
    const local = branch?.point ?? (this.#parts.shown.leaves ? pickCrown(tree.crown, ray, box) : null);
    if (!local) return;
    const point = local.applyMatrix4(matrixWorld);
    const distance = raycaster.ray.origin.distanceTo(point);
    if (distance < raycaster.near || distance > raycaster.far) return;
    intersects.push({ distance, point, object: this, ...(branch ? { index: branch.piece } : {}) });
  }

  /** Frees everything on the GPU; the tree may be given anew. */
  override dispose(): void {
    this.#dropTextures();
    this.#parts.dispose();
    this.#tree = null;
  }

  #prepare(renderer: WebGLRenderer, tree: PackedTree): { textures: TreeTextures; poser: Poser } {
    if (this.#textures && this.#poser) return { textures: this.#textures, poser: this.#poser };
    const textures = new TreeTextures(tree, capabilitiesOf(renderer).floatTargets);
    const poser = textures.cpuPose ? new CpuPoser(textures) : new WindPass(textures);
    const { shared } = this.#parts;
    shared.branches.value = textures.branches;
    shared.leaves.value = textures.leaves;
    shared.poseLog2Width.value = Math.log2(tree.restPose.width);
    shared.branchLog2Width.value = Math.log2(tree.branches.width);
    shared.leafLog2Width.value = Math.log2(tree.leaves.width);
    this.#textures = textures;
    this.#poser = poser;
    return { textures, poser };
  }

  #dropTextures(): void {
    this.#parts.visible = false;
    this.#poser?.dispose();
    this.#textures?.dispose();
    this.#poser = null;
    this.#textures = null;
  }

  #show(): void {
    const { shown } = this.#parts;
    shown.levels = this.#levels;
    const all = this.#levels >= (this.#tree?.levels.length ?? 0);
    shown.leaves = this.#leaves === 'auto' ? all : this.#leaves;
  }
}
