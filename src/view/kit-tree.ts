import { type Intersection, Matrix4, Object3D, Ray, type Raycaster, Vector2, type WebGLRenderer } from 'three';
import type { PackedTree } from '../core/pack/packed.ts';
import type { StemTable } from '../core/pack/stem-table.ts';
import type { Species } from '../core/species/species.ts';
import type { Wind } from '../core/wind/wind.ts';
import type { ReadBack } from '../gpu/poser.ts';
import type { WindSource } from '../gpu/wind-source.ts';
import type { Degradation, DrawnElements, PaperRange } from './degradation.ts';
import { type Detail, LEAF_BUDGET } from './detail.ts';
import type { ChannelView } from './picture/picture.ts';
import { windBox } from './tree-extent.ts';
import type { TreeKit } from './tree-kit.ts';
import { type Mode, TreeParts } from './tree-parts.ts';
import type { SharedUniforms } from './uniforms.ts';
import { WindLane } from './wind-lane.ts';

export type { Degradation, DrawnElements, PaperRange } from './degradation.ts';
export type { Mode } from './tree-parts.ts';

/** How a tree is drawn. */
export interface WindTreeOptions {
  /** `auto` (default) goes by size on screen. */
  detail?: Detail;
  /** Leaves drawn at most; the rest is left out evenly and the others grow to cover as much. */
  leafBudget?: number;
  /** What is left out at range: what does not show (`screen`, default), or what Weber & Penn's rules leave out. */
  degradation?: Degradation;
}

/** Which of two winds on the same tree: A is its own, B the one that it is compared with. */
export type Which = 'A' | 'B';

/** What WindTree is, drawn with what a kit gives it. */
export class KitTree extends Object3D {
  readonly isWindTree = true;
  /**
   * Springs of a tree that is set begin with the wind of the moment, so that one tree follows another without a run from time 0; `settle`
   * makes up for it. Default false: what is seen is a function of the time alone.
   */
  startsNear = false;
  /** How the paper's rules of degradation are applied; may be changed at any time. */
  readonly paperRange: PaperRange = { quality: 1, season: 'summer', evergreen: false, r2: null };
  readonly #parts: TreeParts;
  readonly #kit: TreeKit;
  readonly #a: WindLane;
  #b: WindLane | null = null;
  #tree: PackedTree | null = null;
  #species: Species | null = null;
  #time = 0;
  #leaves: boolean | 'auto' = 'auto';
  #levels = Number.POSITIVE_INFINITY;
  #paperLoaded: Promise<void> | null = null;
  readonly #size = new Vector2();

  constructor(
    kit: TreeKit,
    { detail = 'auto', leafBudget = LEAF_BUDGET[detail], degradation = 'screen' }: WindTreeOptions = {},
  ) {
    super();
    this.#kit = kit;
    this.#a = new WindLane(kit);
    this.name = 'wind tree';
    this.#parts = new TreeParts(
      { mode: 'shaded', levels: Number.POSITIVE_INFINITY, leaves: true, detail, leafBudget },
      kit,
    );
    this.#parts.visible = false;
    this.degradation = degradation;
    this.add(this.#parts);
  }

  /** Takes a tree; the old one goes. What is drawn changes with the next `update`. */
  setTree(packed: PackedTree, species: Species): void {
    // In other colours the same tree moves on as it did.
    if (packed !== this.#tree) {
      this.#parts.visible = false;
      this.#a.leave();
      this.#b?.leave();
    }
    this.#tree = packed;
    this.#species = species;
    this.#parts.setTree(packed, species);
    this.#applyShown();
  }

  /** Lets a wind blow, fading over from the last one in `fade` seconds of the clock (default: at once). */
  setWind(wind: Wind, { fade = 0 }: { fade?: number } = {}): void {
    this.#a.felt.set(wind, this.#time, fade);
  }

  /** The wind that blows or is fading in. */
  get wind(): Wind {
    return this.#a.felt.wind;
  }

  /**
   * Poses the tree in a second wind, B, as well: `show('B')` before a rendering draws it, `show('A')` goes back. It shares all but the
   * pose with A. null: A alone, and B costs nothing. `fade` as in `setWind`.
   */
  compareWith(wind: Wind | null, { fade = 0 }: { fade?: number } = {}): void {
    if (!wind) {
      this.#b?.drop();
      this.#b = null;
      return;
    }
    this.#b ??= new WindLane(this.#kit);
    this.#b.felt.set(wind, this.#time, fade);
  }

  /** Draws the tree in wind A or B from now on, as `update` has posed it; A where there is no B. */
  show(which: Which): void {
    const lane = this.#lane(which);
    const species = this.#species;
    if (!lane.textures || !species) return;
    const { shared, leaves } = this.#parts;
    shared.poseEven.value = lane.textures.uniforms.poseEven.value;
    shared.poseOdd.value = lane.textures.uniforms.poseOdd.value;
    this.#parts.setPaper(lane.felt.wind.paper);
    // Every leaf beats a whole number of times in sixteen beats, so this may wrap (shaders/leaf/swing.glsl).
    const beats = (this.#time * species.wind.flutterRate) / 16;
    leaves.setWind(beats - Math.floor(beats), lane.way);
  }

  /** The wind that the tree feels, as a pass takes it. */
  windSource(which: Which = 'A'): WindSource {
    return this.#lane(which).felt;
  }

  /** What shaders need that read the pose of what is shown: the objects stay, their values change. */
  get poseUniforms(): Pick<SharedUniforms, 'poseEven' | 'poseOdd' | 'poseLog2Width'> {
    return this.#parts.shared;
  }

  /** Poses the tree as of `time` seconds: runs the wind pass, or the CPU reference where the GPU lacks float targets. */
  update(renderer: WebGLRenderer, time: number): void {
    const species = this.#species;
    if (!this.#tree || !species) return;
    this.#time = time;
    this.updateWorldMatrix(true, false);
    for (const lane of this.#b ? [this.#a, this.#b] : [this.#a]) {
      lane.felt.moveTo(this.matrixWorld);
      lane.update(renderer, this.#tree, time, this.startsNear);
    }
    this.#prepare(this.#tree);
    this.show('A');
    this.#parts.pictureHeight = renderer.getDrawingBufferSize(this.#size).y;
    this.#parts.visible = true;
  }

  /** What `startsNear` has begun is run from time 0 again, by the next updates. */
  settle(): void {
    this.#a.settle();
    this.#b?.settle();
  }

  /** Levels below this one are drawn; all by default. */
  get levelsShown(): number {
    return this.#levels;
  }

  set levelsShown(levels: number) {
    this.#levels = levels;
    this.#applyShown();
  }

  /** Whether leaves are drawn; `auto`, the default: when all levels are. */
  get showLeaves(): boolean | 'auto' {
    return this.#leaves;
  }

  set showLeaves(leaves: boolean | 'auto') {
    this.#leaves = leaves;
    this.#applyShown();
  }

  get mode(): Mode {
    return this.#parts.shown.mode;
  }

  set mode(mode: Mode) {
    this.#parts.shown.mode = mode;
    this.#parts.applyMode();
  }

  /** Colours the tree by what engines get of its wind, `stems` being its own, until another tree is set; null: as `mode` says. */
  showChannel(channel: ChannelView | null, stems: StemTable): void {
    const tree = this.#tree;
    const species = this.#species;
    if (!tree || !species) return;
    const texels = channel && this.#kit.channelTexels?.(tree, stems, species, channel);
    if (texels !== undefined) this.#parts.setChannel(channel, texels);
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

  /** What is left out at range. */
  get degradation(): Degradation {
    return this.#parts.shown.paper ? 'paper' : 'screen';
  }

  set degradation(degradation: Degradation) {
    this.#parts.shown.paper = degradation === 'paper' ? this.paperRange : null;
    if (degradation === 'paper') this.#paperLoaded ??= this.#parts.loadDegradation();
  }

  /** Kept once the code of `paper` is there, where that has been asked for; until then the tree is drawn as `screen` says. */
  async degradationLoaded(): Promise<void> {
    await this.#paperLoaded;
  }

  /** What the last frame drew by the paper's rules; null where it did not. */
  get elementsDrawn(): DrawnElements | null {
    return this.#parts.elementsDrawn;
  }

  /** How far the normals of the leaves turn towards the outside of the crown, 0..1. */
  get crownRounding(): number {
    return this.#parts.leaves.look.crownRounding.value;
  }

  set crownRounding(amount: number) {
    this.#parts.leaves.look.crownRounding.value = amount;
  }

  /** Sets both for every part of the tree. */
  setShadows(cast: boolean, receive: boolean): void {
    this.#parts.setShadows(cast, receive);
  }

  /** What the last frame drew. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number; bytes: number } {
    let bytes = 0;
    for (const lane of [this.#a, this.#b]) bytes += (lane?.textures?.bytes ?? 0) + (lane?.poser?.bytes ?? 0);
    return { ...this.#parts.stats(), bytes };
  }

  /** The pose as last computed, laid out as `PackedTree.restPose.data`; null before the first `update`. Slow. */
  readPose(renderer: WebGLRenderer, which: Which = 'A'): Float32Array | null {
    return this.#lane(which).poser?.read(renderer) ?? null;
  }

  /** Part (0..1) of the way to the time of the last `update` that a far jump of the springs has made; null: it is drawn as of then. */
  get catchingUp(): number | null {
    const parts = [this.#a, this.#b].flatMap((lane) => lane?.poser?.catchingUp ?? []);
    return parts.length > 0 ? Math.min(...parts) : null;
  }

  /** Pose and springs' state as last computed, without waiting for the GPU; null before the first `update` or without a context. */
  async readBack(renderer: WebGLRenderer, which: Which = 'A'): Promise<ReadBack | null> {
    return (await this.#lane(which).poser?.readBack(renderer)) ?? null;
  }

  /** The 16 numbers of a piece's pose, P0 to P3, likewise; null where there is no such piece, too. */
  async readPiece(renderer: WebGLRenderer, piece: number, which: Which = 'A'): Promise<Float32Array | null> {
    return (await this.#lane(which).poser?.readPiece(renderer, piece)) ?? null;
  }

  /**
   * The piece that a ray in the world meets, within the levels that are shown. `pose`: as `readBack` gives it, by default at rest;
   * `near`: how far beside the ray it may be where none is met, metres a metre of distance.
   */
  pick(ray: Ray, { pose, near = 0 }: { pose?: Float32Array | null; near?: number } = {}): number | null {
    const tree = this.#tree;
    const { pick } = this.#kit;
    if (!tree || !pick) return null;
    const picking = { places: this.#places(tree), near, ...(pose ? { pose } : {}) };
    return pick.branch(tree, this.#localRay(ray), picking)?.piece ?? null;
  }

  /** Answers with the branch that the ray meets at rest, else with the crown as an ellipsoid. */
  override raycast(raycaster: Raycaster, intersects: Intersection[]): void {
    const tree = this.#tree;
    const { pick } = this.#kit;
    if (!tree || !pick) return;
    const ray = this.#localRay(raycaster.ray);
    const box = windBox(tree.bounds);
    if (!ray.intersectsBox(box)) return;
    const branch = pick.branch(tree, ray, { places: this.#places(tree) });
    const local = branch?.point ?? (this.#parts.shown.leaves ? pick.crown(tree.crown, ray, box) : null);
    if (!local) return;
    const point = local.applyMatrix4(this.#parts.matrixWorld);
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

  #localRay(ray: Ray): Ray {
    return new Ray().copy(ray).applyMatrix4(new Matrix4().copy(this.#parts.matrixWorld).invert());
  }

  /** Places of the draw order that the levels shown take. */
  #places({ levels }: PackedTree): number {
    return levels.slice(0, this.#levels).reduce((end, { start, count }) => Math.max(end, start + count), 0);
  }

  #lane(which: Which): WindLane {
    return which === 'B' && this.#b ? this.#b : this.#a;
  }

  /** Hands what does not move to the shaders: that of A serves both. */
  #prepare(tree: PackedTree): void {
    const { textures } = this.#a;
    const { shared } = this.#parts;
    if (!textures || shared.branches.value === textures.branches) return;
    shared.branches.value = textures.branches;
    shared.leaves.value = textures.leaves;
    shared.poseLog2Width.value = Math.log2(tree.restPose.width);
    shared.branchLog2Width.value = Math.log2(tree.branches.width);
    shared.leafLog2Width.value = Math.log2(tree.leaves.width);
  }

  #dropTextures(): void {
    this.#parts.visible = false;
    this.#a.drop();
    this.#b?.drop();
  }

  #applyShown(): void {
    const { shown } = this.#parts;
    shown.levels = this.#levels;
    const all = this.#levels >= (this.#tree?.levels.length ?? 0);
    shown.leaves = this.#leaves === 'auto' ? all : this.#leaves;
  }
}
