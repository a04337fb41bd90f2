import {
  type Box3,
  type Camera,
  type DataArrayTexture,
  DoubleSide,
  type InstancedBufferGeometry,
  LineSegments,
  Mesh,
  Object3D,
  type ShaderMaterial,
  type Vector2,
  type Vector3,
  type Vector4,
} from 'three';
import type { GroveLight } from '../core/look/grove-light.ts';
import { COLLAR, levelShape } from '../core/mesh/level-shape.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { deepLod, deepShare, disposeBarkLook, type StemForm, setBarkLook } from './bark-look.ts';
import { branchGeometry, bundleFor, recount } from './branch-geometry.ts';
import { CHANNELS, channelUniforms } from './channel-look.ts';
import { castCoarsely } from './coarse-shadow.ts';
import type { DrawnElements, PaperRange } from './degradation.ts';
import type { DegradedTree } from './degraded-tree.ts';
import { type Detail, type GridDetail, gridDetail, shadowBands, stemsDrawn } from './detail.ts';
import type { Foliage, GroveParts } from './forest/grove-parts.ts';
import { sectorsForLobes } from './grid.ts';
import { morphTo, type NextGrid, nextGrid } from './grid-morph.ts';
import { levelColour } from './level-colours.ts';
import type { ChannelView } from './picture/picture.ts';
import { pixelsPerMetre } from './pixel-size.ts';
import { stemDefines } from './stem-defines.ts';
import { type LevelExtent, levelExtents, windBox } from './tree-extent.ts';
import type { TreeKit } from './tree-kit.ts';
import { TreeLeaves } from './tree-leaves.ts';
import { branchMaterials, disposeMaterials, dress, type MaterialSet } from './tree-materials.ts';
import { barkUniforms, type LevelUniforms, levelUniforms, type SharedUniforms, sharedUniforms } from './uniforms.ts';

/** How a tree is drawn: its surface, its triangles, what the GPU moves, or its stems coloured by level. */
export type Mode = 'shaded' | 'wireframe' | 'control' | 'levels';

/** Pieces of a level that are looked at in a grove: its draw order is spread evenly over its trees. */
const GROVE_SAMPLE = 512;

/** What is to be drawn of a tree. */
export interface Shown {
  mode: Mode;
  /** Levels below this one are drawn. */
  levels: number;
  leaves: boolean;
  detail: Detail;
  leafBudget: number;
  /** Leaves out at range what Weber & Penn's rules do, in place of what does not show. */
  paper?: PaperRange | null;
}

/** A mesh whose vertices the shader makes. */
export type TreeMesh = Mesh<InstancedBufferGeometry>;

interface Level {
  readonly mesh: TreeMesh;
  readonly uniforms: LevelUniforms;
  /** By their form; made when they are first needed. */
  sets: Partial<Record<StemForm, MaterialSet>>;
  extent: LevelExtent;
  start: number;
  count: number;
  /** Stands for the sectors and bands of the mesh's geometry; 0 for none. Compared for every camera: it allocates nothing. */
  drawn: number;
  /** Pieces that it draws. */
  many: number;
  /** What follows what is drawn. */
  next: NextGrid | null;
}

/**
 * The meshes of one tree, in tree space (z up).
 *
 * It passes for a THREE.LOD, so that three itself asks it, for every camera, how finely to draw; nobody has to remember to.
 */
export class TreeParts extends Object3D {
  readonly isLOD = true;
  readonly autoUpdate = true;
  readonly shared: SharedUniforms;
  readonly bark = barkUniforms();
  readonly shown: Shown;
  readonly channelLook = channelUniforms();
  readonly kit: TreeKit;
  readonly leaves: TreeLeaves;
  /** What hangs on the branches: the leaves, or what a grove has in their place. */
  readonly #foliage: Foliage;
  readonly #grove: GroveParts | null;
  /** Draws by the paper's rules of degradation; loaded when they are first asked for. */
  #degraded: DegradedTree | null = null;
  readonly #lineScale = { value: 540 };
  #channel: ChannelView | null = null;
  /** Height of the picture in pixels, for the choice of detail. */
  pictureHeight = 1080;
  #levels: Level[] = [];
  #lines: LineSegments<InstancedBufferGeometry, ShaderMaterial> | null = null;
  #tree: PackedTree | null = null;
  #species: Species | null = null;
  #box: Box3 | null = null;
  #paper = false;
  #shadows = { cast: true, receive: true };

  /** `grove`: it is not one tree that is drawn but many that were merged. */
  constructor(shown: Shown, kit: TreeKit, grove: GroveParts | null = null) {
    super();
    this.shown = shown;
    this.kit = kit;
    this.leaves = new TreeLeaves(this);
    this.#grove = grove;
    this.shared = { ...sharedUniforms(), ...grove?.uniforms };
    this.#foliage = grove?.foliage?.(this) ?? this.leaves;
    this.rotation.x = -Math.PI / 2; // z up to y up
    this.name = 'tree parts';
  }

  /** Makes drawing by the paper's rules possible: most never do, and need not wait for its code. */
  async loadDegradation(): Promise<void> {
    const { DegradedTree } = await import('./degraded-tree.ts');
    const { kit, shown, shared, bark, channelLook } = this;
    this.#degraded ??= new DegradedTree({
      kit,
      shown,
      shared,
      bark,
      look: this.leaves.look,
      channelLook,
      lineScale: this.#lineScale,
      viewDefines: () => this.viewDefines(),
      adopt: (part, name) => this.#adopt(part, name),
    });
  }

  /** Trees that are drawn as one. */
  get treeCount(): number {
    return this.#grove?.count ?? 1;
  }

  /** Pixels that a metre takes of what is in `box`; in a grove at the tree that is nearest. */
  scaleOf(camera: Camera, box: Box3): number {
    const { matrixWorld, pictureHeight } = this;
    return this.#grove
      ? this.#grove.nearest(camera, matrixWorld, pictureHeight)
      : pixelsPerMetre(camera, matrixWorld, box, pictureHeight);
  }

  /** Takes a new tree. Materials and their programs stay; geometry is made anew at the next frame. `light`: that of a grove's crowns. */
  setTree(tree: PackedTree, species: Species, light?: GroveLight): void {
    this.#tree = tree;
    this.#box = windBox(tree.bounds);
    const extents = levelExtents(tree, this.#grove ? GROVE_SAMPLE : undefined);
    while (this.#levels.length > tree.levels.length) this.#dropLevel();
    const former = this.#species;
    this.#species = species;
    tree.levels.forEach(({ start, count }, i) => {
      const level = this.#levels[i] ?? this.#addLevel(i);
      Object.assign(level, { start, count, extent: extents[i], drawn: 0 });
      const same = former && String(stemDefines(i, former, false)) === String(stemDefines(i, species, false));
      if (!same) this.#dropMaterials(level);
      this.#setShape(level, i, species);
    });
    this.#setLook(tree, species);
    this.#degraded?.leave();
    this.leaves.setTree(tree, species, light);
    if (this.#foliage !== this.leaves) this.#foliage.setTree(tree, species, light);
    this.applyMode();
  }

  /** Chooses what is drawn for this camera; three calls it while it looks for what is visible. */
  update(camera: Camera): void {
    const { shown } = this;
    const tree = this.#tree;
    if (!tree || !this.#species || !this.#box) return;
    const surfaces = shown.mode !== 'control';
    const degraded = this.#degraded;
    const paper = surfaces && degraded ? shown.paper : null;
    if (degraded && paper) {
      const place = { matrixWorld: this.matrixWorld, box: this.#box, pictureHeight: this.pictureHeight };
      const levels = this.#levels.map(({ uniforms }) => uniforms);
      degraded.fit(camera, place, tree, this.#species, levels, paper);
    } else degraded?.hide();
    this.#levels.forEach((level, i) => {
      level.mesh.visible = surfaces && !paper && i < shown.levels && level.count > 0;
      if (level.mesh.visible) this.#fitLevel(level, i, camera);
    });
    if (paper) for (const mesh of this.#foliage.meshes()) mesh.visible = false;
    else this.#foliage.fit(camera, this.#box);
    this.#fitLines(tree);
  }

  /** Triangles, draw calls, pieces and leaves of the frame that was drawn last, shadows left out. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number } {
    const atRange = this.#atRange;
    if (atRange) {
      const pieces = this.#levels.slice(0, this.shown.levels).reduce((sum, { count }) => sum + count, 0);
      return { ...atRange.stats(), pieces };
    }
    const drawn = this.#levels.filter(({ mesh }) => mesh.visible);
    const meshes = [...drawn.map(({ mesh }) => mesh), ...this.#foliage.meshes().filter(({ visible }) => visible)];
    return {
      triangles: meshes.reduce((sum, { geometry }) => sum + Number(geometry.userData.triangles ?? 0), 0),
      drawCalls: meshes.length + (this.#lines?.visible ? 1 : 0),
      pieces: drawn.reduce((sum, { many }) => sum + many, 0),
      leaves: this.#foliage.count,
    };
  }

  /** The time in sixteenths of a beat, 0..1, and where the wind blows to. */
  setWind(beats: number, way: Vector2): void {
    this.#foliage.setWind(beats, way);
  }

  /** What the last frame drew by the paper's rules of degradation; null where it did not. */
  get elementsDrawn(): DrawnElements | null {
    return this.#atRange?.drawn() ?? null;
  }

  /** What draws by the paper's rules, where it does. */
  get #atRange(): DegradedTree | null {
    return this.shown.paper && this.shown.mode !== 'control' ? this.#degraded : null;
  }

  /** Draws by the paper's printed frames and sections, for teaching. */
  setPaper(paper: boolean): void {
    if (this.#paper === paper) return;
    this.#paper = paper;
    for (const level of this.#levels) this.#dropMaterials(level);
  }

  /** Their programs are others: what is drawn next makes them anew. */
  #dropAllMaterials(): void {
    for (const level of this.#levels) this.#dropMaterials(level);
    this.#foliage.dropMaterials();
    this.#degraded?.dropMaterials();
  }

  setShadows(cast: boolean, receive: boolean): void {
    this.#shadows = { cast, receive };
    for (const mesh of [...this.#meshes(), ...(this.#degraded?.objects() ?? [])]) {
      Object.assign(mesh, { castShadow: cast && !(mesh instanceof LineSegments), receiveShadow: receive });
    }
  }

  /** Colours the tree by a channel, of which `texels` (its own from now on) tells; null: as bark and leaves are. */
  setChannel(channel: ChannelView | null, texels: DataArrayTexture | null): void {
    const { channelTexels, channelKind } = this.channelLook;
    channelTexels.value?.dispose();
    channelTexels.value = texels;
    channelKind.value = channel ? CHANNELS.indexOf(channel) : 0;
    const switched = (channel === null) !== (this.#channel === null);
    this.#channel = channel;
    if (switched) this.#dropAllMaterials();
    this.applyMode();
  }

  /** Frees everything; a tree that is set afterwards makes anew what it needs. */
  override dispose(): void {
    while (this.#levels.length > 0) this.#dropLevel();
    this.leaves.dispose();
    this.#degraded?.dispose();
    if (this.#foliage !== this.leaves) this.#foliage.dispose();
    this.#lines?.geometry.dispose();
    this.#lines?.material.dispose();
    disposeBarkLook(this.bark);
    this.channelLook.channelTexels.value?.dispose();
    this.channelLook.channelTexels.value = null;
    this.#lines = null;
    this.clear();
  }

  #meshes(): TreeMesh[] {
    return [...this.#levels.map(({ mesh }) => mesh), ...this.#foliage.meshes()];
  }

  #addLevel(index: number): Level {
    const uniforms = levelUniforms();
    const mesh = this.newMesh(`level ${index}`);
    const level: Level = {
      mesh,
      uniforms,
      sets: {},
      extent: { box: mesh.userData.box, radius: 0, slenderness: 0 },
      start: 0,
      count: 0,
      drawn: 0,
      many: 0,
      next: null,
    };
    this.#levels.push(level);
    return level;
  }

  /** A mesh of this tree, without a geometry. */
  newMesh(name: string): TreeMesh {
    const mesh = this.#adopt(new Mesh() as TreeMesh, name);
    castCoarsely(mesh);
    return mesh;
  }

  #adopt<Part extends Object3D>(part: Part, name: string): Part {
    part.name = name;
    part.castShadow = this.#shadows.cast;
    part.receiveShadow = this.#shadows.receive;
    part.raycast = () => {}; // the tree as a whole answers a ray
    this.add(part);
    part.updateWorldMatrix(true, false); // it may come after the scene's matrices were updated for this frame
    return part;
  }

  #dropLevel(): void {
    const level = this.#levels.pop();
    if (!level) return;
    this.#degraded?.dispose(); // it draws with the uniforms of the levels
    this.remove(level.mesh);
    level.mesh.geometry.dispose();
    this.#dropMaterials(level);
  }

  #dropMaterials(level: Level): void {
    for (const set of Object.values(level.sets)) disposeMaterials(set);
    Object.assign(level, { sets: {}, drawn: 0 });
  }

  #setShape({ uniforms }: Level, index: number, species: Species): void {
    const { taper, flare, lobes, lobeDepth, lobeFade, bulges, bulgeDepth } = levelShape(species, index);
    const [a, b] = uniforms.stemShape.value as [Vector4, Vector4];
    a.set(taper, flare, lobes, lobeDepth);
    b.set(lobeFade, bulges, bulgeDepth, COLLAR);
  }

  #setLook(tree: PackedTree, { bark }: Species): void {
    const { shared } = this;
    shared.crownCentre.value.fromArray(tree.crown, 0);
    shared.crownRadii.value.fromArray(tree.crown, 3);
    const [low, size] = this.channelLook.channelBox.value as [Vector3, Vector3];
    low.fromArray(tree.bounds, 0);
    size.fromArray(tree.bounds, 3).sub(low);
    setBarkLook(this.bark, bark, this.kit);
    for (const { sets } of this.#levels) {
      for (const set of Object.values(sets)) set.standard.roughness = bark.roughness;
    }
  }

  #fitLevel(level: Level, index: number, camera: Camera): void {
    const { extent, count, mesh, uniforms } = level;
    const scale = this.scaleOf(camera, extent.box);
    const pixels = extent.radius * scale;
    const { bark } = this.#species as Species;
    const deepAt = (radius: number): number => deepShare(index, bark, radius, radius / extent.radius);
    const gridAt = (radius: number): GridDetail =>
      gridDetail(index, radius, count / this.treeCount, this.shown.detail, extent.slenderness, deepAt(radius) > 0);
    const deep = deepAt(pixels);
    const grid = gridAt(pixels);
    const [a] = uniforms.stemShape.value as [Vector4, Vector4];
    const sectors = sectorsForLobes(grid.sectors, a.z, a.w);
    // The rest of the spec is the tree's: `setTree` forgets what was drawn.
    const shadow = shadowBands(index, grid.bands, this.shown.detail);
    const drawn = ((shadow * 2 + (deep > 0 ? 1 : 0)) * 256 + sectors) * 256 + grid.bands;
    uniforms.barkDepth.value.set(deep * bark.depth, deepLod(bark, extent.radius, sectors));
    // A trunk is never thinned: it carries all that is seen.
    const many = index === 0 ? count : stemsDrawn(count, pixels, this.shown.detail);
    uniforms.stemGrowth.value = count / many;
    const fresh = level.drawn !== drawn || level.many !== many;
    if (fresh) level.next = pixels > 0 ? nextGrid(pixels, gridAt) : null;
    const { next } = level;
    const gathers = next !== null && next.bands <= grid.bands && !(a.x > 1.2 && a.x <= 2);
    uniforms.gridMorph.value.set(
      next ? morphTo(next, pixels) : 0,
      grid.bands,
      gathers ? next.bands : grid.bands,
      next?.sectors === 1 ? sectors : 0,
    );
    if (!fresh) return;
    // Below 1 the taper leaves the tip open.
    const spec = {
      sectors,
      bands: grid.bands,
      cap: a.x < 1,
      round: a.x > 1.2 && a.x <= 2,
      bundle: bundleFor(count),
      coarse: next ? sectorsForLobes(next.sectors, a.z, a.w) : 1,
    };
    const made = String([...Object.values(spec), shadow]);
    if (made === mesh.geometry.userData.made) {
      recount(mesh.geometry, many, spec.bundle, this.#box as Box3);
    } else {
      mesh.geometry.dispose();
      mesh.geometry = branchGeometry(spec, many, this.#box as Box3, shadow);
      mesh.geometry.userData.made = made;
    }
    uniforms.branchRange.value.set(level.start, many, spec.bundle);
    const { standard } = this.#branchSet(level, index, sectors === 1 ? 'ribbon' : deep > 0 ? 'deep' : 'tube');
    // In shadow maps every stem is a ribbon that faces the light: the outline is the same.
    dress(mesh, { ...this.#branchSet(level, index, 'ribbon'), standard });
    Object.assign(level, { drawn, many });
  }

  #branchSet(level: Level, index: number, form: StemForm): MaterialSet {
    const made = level.sets[form];
    if (made) return made;
    const species = this.#species as Species;
    const set = branchMaterials([...stemDefines(index, species, this.#paper, form), 'MORPHED', ...this.viewDefines()], {
      ...this.shared,
      ...this.bark,
      ...this.channelLook,
      ...level.uniforms,
    });
    set.standard.roughness = species.bark.roughness;
    set.standard.shadowSide = DoubleSide;
    set.standard.wireframe = this.shown.mode === 'wireframe';
    level.sets[form] = set;
    return set;
  }

  /** Names that every material of the tree is compiled with. */
  viewDefines(): string[] {
    return [this.#channel ? 'CHANNEL_VIEW' : '', this.#grove ? 'GROVE' : ''].filter(Boolean);
  }

  #fitLines(tree: PackedTree): void {
    const wanted = this.shown.mode === 'control';
    if (this.#lines) this.#lines.visible = wanted;
    const { lines } = this.kit;
    if (!wanted || !lines) return;
    if (!this.#lines) {
      this.#lines = lines.make(this.shared);
      this.#lines.raycast = () => {};
      this.add(this.#lines);
      this.#lines.updateWorldMatrix(true, false);
    }
    const ends = tree.levels.map(({ start, count }) => start + count);
    const levels = Math.min(this.shown.levels, ends.length);
    lines.fit(this.#lines, levels > 0 ? (ends[levels - 1] as number) : 0, ends, this.#box as Box3);
  }

  /** Takes `shown.mode` over into the materials. */
  applyMode(): void {
    const { mode } = this.shown;
    this.#levels.forEach(({ sets, uniforms }, i) => {
      for (const set of Object.values(sets)) set.standard.wireframe = mode === 'wireframe';
      const tint = colourOf(i);
      // A channel stands in place of the tint; its surface is as plain.
      uniforms.levelTint.value.set(tint[0], tint[1], tint[2], mode === 'levels' || this.#channel ? 1 : 0);
    });
    this.#foliage.setWireframe(mode === 'wireframe');
    this.#degraded?.setWireframe(mode === 'wireframe');
  }
}

import { Color } from 'three';

function colourOf(level: number): [number, number, number] {
  const { r, g, b } = new Color(levelColour(level));
  return [r, g, b];
}
