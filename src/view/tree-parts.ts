import {
  type Box3,
  type Camera,
  type DataArrayTexture,
  type InstancedBufferGeometry,
  type LineSegments,
  Mesh,
  Object3D,
  type ShaderMaterial,
  type Vector3,
  type Vector4,
} from 'three';
import { COLLAR, levelShape } from '../core/mesh/level-shape.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { barkDefines, deepLod, deepShare, disposeBarkLook, type StemForm, setBarkLook } from './bark-look.ts';
import { branchGeometry, bundleFor, recount } from './branch-geometry.ts';
import { CHANNELS, channelUniforms } from './channel-texels.ts';
import { controlLines, setControlLines } from './control-lines.ts';
import { type Detail, gridDetail } from './detail.ts';
import { sectorsForLobes } from './grid.ts';
import { levelColour } from './level-colours.ts';
import type { ChannelView } from './picture/picture.ts';
import { pixelsPerMetre } from './pixel-size.ts';
import { type LevelExtent, levelExtents, windBox } from './tree-extent.ts';
import { TreeLeaves } from './tree-leaves.ts';
import { branchMaterials, disposeMaterials, dress, type MaterialSet } from './tree-materials.ts';
import { barkUniforms, type LevelUniforms, levelUniforms, sharedUniforms } from './uniforms.ts';

/** How a tree is drawn: its surface, its triangles, what the GPU moves, or its stems coloured by level. */
export type Mode = 'shaded' | 'wireframe' | 'control' | 'levels';

/** What is to be drawn of a tree. */
export interface Shown {
  mode: Mode;
  /** Levels below this one are drawn. */
  levels: number;
  leaves: boolean;
  detail: Detail;
  leafBudget: number;
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
}

/** The parts of the deformer's programs that a level needs; each that is left out saves work at every vertex. */
function definesOf(level: number, species: Species, paper: boolean, form: StemForm = 'tube'): string[] {
  const { taper, lobeDepth, bulgeDepth } = levelShape(species, level);
  const plain = level > 0 && bulgeDepth === 0 && lobeDepth === 0 && taper <= 1;
  const shape = [level === 0 ? 'FLARED' : '', plain ? 'PLAIN_STEM' : '', paper ? 'PAPER_FORMS' : ''].filter(Boolean);
  return [...shape, ...barkDefines(level, species, form), ...(form === 'ribbon' ? ['RIBBON'] : [])];
}

/**
 * The meshes of one tree, in tree space (z up).
 *
 * It passes for a THREE.LOD, so that three itself asks it, for every camera, how finely to draw; nobody has to remember to.
 */
export class TreeParts extends Object3D {
  readonly isLOD = true;
  readonly autoUpdate = true;
  readonly shared = sharedUniforms();
  readonly bark = barkUniforms();
  readonly shown: Shown;
  readonly channelLook = channelUniforms();
  readonly leaves = new TreeLeaves(this);
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

  constructor(shown: Shown) {
    super();
    this.shown = shown;
    this.rotation.x = -Math.PI / 2; // z up to y up
    this.name = 'tree parts';
  }

  /** Takes a new tree. Materials and their programs stay; geometry is made anew at the next frame. */
  setTree(tree: PackedTree, species: Species): void {
    this.#tree = tree;
    this.#box = windBox(tree.bounds);
    const extents = levelExtents(tree);
    while (this.#levels.length > tree.levels.length) this.#dropLevel();
    const former = this.#species;
    this.#species = species;
    tree.levels.forEach(({ start, count }, i) => {
      const level = this.#levels[i] ?? this.#addLevel(i);
      Object.assign(level, { start, count, extent: extents[i], drawn: 0 });
      const same = former && String(definesOf(i, former, false)) === String(definesOf(i, species, false));
      if (!same) this.#dropMaterials(level);
      this.#setShape(level, i, species);
    });
    this.#setLook(tree, species);
    this.leaves.setTree(tree, species);
    this.#applyMode();
  }

  /** Chooses what is drawn for this camera; three calls it while it looks for what is visible. */
  update(camera: Camera): void {
    const { shown } = this;
    const tree = this.#tree;
    if (!tree || !this.#species || !this.#box) return;
    const surfaces = shown.mode !== 'control';
    this.#levels.forEach((level, i) => {
      level.mesh.visible = surfaces && i < shown.levels && level.count > 0;
      if (level.mesh.visible) this.#fitLevel(level, i, camera);
    });
    this.leaves.fit(camera, this.#box);
    this.#fitLines(tree);
  }

  /** Triangles, draw calls, pieces and leaves of the frame that was drawn last, shadows left out. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number } {
    const drawn = this.#levels.filter(({ mesh }) => mesh.visible);
    const meshes = [...drawn.map(({ mesh }) => mesh), ...this.leaves.meshes().filter(({ visible }) => visible)];
    return {
      triangles: meshes.reduce((sum, { geometry }) => sum + Number(geometry.userData.triangles ?? 0), 0),
      drawCalls: meshes.length + (this.#lines?.visible ? 1 : 0),
      pieces: drawn.reduce((sum, { count }) => sum + count, 0),
      leaves: this.leaves.count,
    };
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
    this.leaves.dropMaterials();
  }

  setShadows(cast: boolean, receive: boolean): void {
    this.#shadows = { cast, receive };
    for (const mesh of this.#meshes()) Object.assign(mesh, { castShadow: cast, receiveShadow: receive });
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
    this.#applyMode();
  }

  /** Takes `shown.mode` over into the materials. */
  applyMode(): void {
    this.#applyMode();
  }

  /** Frees everything; a tree that is set afterwards makes anew what it needs. */
  override dispose(): void {
    while (this.#levels.length > 0) this.#dropLevel();
    this.leaves.dispose();
    this.#lines?.geometry.dispose();
    this.#lines?.material.dispose();
    disposeBarkLook(this.bark);
    this.channelLook.channelTexels.value?.dispose();
    this.channelLook.channelTexels.value = null;
    this.#lines = null;
    this.clear();
  }

  #meshes(): TreeMesh[] {
    return [...this.#levels.map(({ mesh }) => mesh), ...this.leaves.meshes()];
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
    };
    this.#levels.push(level);
    return level;
  }

  /** A mesh of this tree, without a geometry. */
  newMesh(name: string): TreeMesh {
    const mesh: TreeMesh = new Mesh();
    mesh.name = name;
    mesh.castShadow = this.#shadows.cast;
    mesh.receiveShadow = this.#shadows.receive;
    mesh.raycast = () => {}; // the tree as a whole answers a ray
    this.add(mesh);
    mesh.updateWorldMatrix(true, false); // it may come after the scene's matrices were updated for this frame
    return mesh;
  }

  #dropLevel(): void {
    const level = this.#levels.pop();
    if (!level) return;
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
    setBarkLook(this.bark, bark);
    for (const { sets } of this.#levels) {
      for (const set of Object.values(sets)) set.standard.roughness = bark.roughness;
    }
  }

  #fitLevel(level: Level, index: number, camera: Camera): void {
    const { extent, count, mesh, uniforms } = level;
    const scale = pixelsPerMetre(camera, this.matrixWorld, extent.box, this.pictureHeight);
    const pixels = extent.radius * scale;
    const { bark } = this.#species as Species;
    const deep = deepShare(index, bark, pixels, scale);
    const grid = gridDetail(index, pixels, count, this.shown.detail, deep > 0 ? extent.slenderness : 0);
    const [a] = uniforms.stemShape.value as [Vector4, Vector4];
    const sectors = sectorsForLobes(grid.sectors, a.z, a.w);
    // The rest of the spec is the tree's: `setTree` forgets what was drawn.
    const drawn = (deep > 0 ? 65536 : 0) + sectors * 256 + grid.bands;
    uniforms.barkDepth.value.set(deep * bark.depth, deepLod(bark, extent.radius, sectors));
    if (level.drawn === drawn) return;
    // Below 1 the taper leaves the tip open.
    const spec = { sectors, bands: grid.bands, cap: a.x < 1, round: a.x > 1.2 && a.x <= 2, bundle: bundleFor(count) };
    const made = String(Object.values(spec));
    if (made === mesh.geometry.userData.made) {
      recount(mesh.geometry, count, spec.bundle, this.#box as Box3);
    } else {
      mesh.geometry.dispose();
      mesh.geometry = branchGeometry(spec, count, this.#box as Box3);
      mesh.geometry.userData.made = made;
    }
    uniforms.branchRange.value.set(level.start, count, spec.bundle);
    dress(mesh, this.#branchSet(level, index, sectors === 1 ? 'ribbon' : deep > 0 ? 'deep' : 'tube'));
    level.drawn = drawn;
  }

  #branchSet(level: Level, index: number, form: StemForm): MaterialSet {
    const made = level.sets[form];
    if (made) return made;
    const species = this.#species as Species;
    const set = branchMaterials([...definesOf(index, species, this.#paper, form), ...this.viewDefines()], {
      ...this.shared,
      ...this.bark,
      ...this.channelLook,
      ...level.uniforms,
    });
    set.standard.roughness = species.bark.roughness;
    set.standard.wireframe = this.shown.mode === 'wireframe';
    level.sets[form] = set;
    return set;
  }

  /** Names that every material of the tree is compiled with. */
  viewDefines(): string[] {
    return this.#channel ? ['CHANNEL_VIEW'] : [];
  }

  #fitLines(tree: PackedTree): void {
    const wanted = this.shown.mode === 'control';
    if (this.#lines) this.#lines.visible = wanted;
    if (!wanted) return;
    if (!this.#lines) {
      this.#lines = controlLines(this.shared);
      this.#lines.raycast = () => {};
      this.add(this.#lines);
      this.#lines.updateWorldMatrix(true, false);
    }
    const ends = tree.levels.map(({ start, count }) => start + count);
    const levels = Math.min(this.shown.levels, ends.length);
    setControlLines(this.#lines, levels > 0 ? (ends[levels - 1] as number) : 0, ends, this.#box as Box3);
  }

  #applyMode(): void {
    const { mode } = this.shown;
    this.#levels.forEach(({ sets, uniforms }, i) => {
      for (const set of Object.values(sets)) set.standard.wireframe = mode === 'wireframe';
      const tint = colourOf(i);
      // A channel stands in place of the tint; its surface is as plain.
      uniforms.levelTint.value.set(tint[0], tint[1], tint[2], mode === 'levels' || this.#channel ? 1 : 0);
    });
    this.leaves.setWireframe(mode === 'wireframe');
  }
}

import { Color } from 'three';

function colourOf(level: number): [number, number, number] {
  const { r, g, b } = new Color(levelColour(level));
  return [r, g, b];
}
