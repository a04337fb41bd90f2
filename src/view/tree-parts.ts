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
import { GRAINS_PER_TILE } from '../core/look/bark-image.ts';
import { type LeafGrain, leafTriangles } from '../core/look/leaf-mesh.ts';
import { COLLAR, levelShape } from '../core/mesh/level-shape.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import type { Species } from '../core/species/species.ts';
import { barkTexture } from './bark-texture.ts';
import { branchGeometry, bundleFor, leafGeometry, recount } from './branch-geometry.ts';
import { CHANNELS, channelUniforms } from './channel-texels.ts';
import { controlLines, setControlLines } from './control-lines.ts';
import { type Detail, gridDetail, leafGrain, leafGrowth, leavesDrawn } from './detail.ts';
import { sectorsForLobes } from './grid.ts';
import { levelColour } from './level-colours.ts';
import type { ChannelView } from './picture/picture.ts';
import { pixelsPerMetre } from './pixel-size.ts';
import { type LevelExtent, levelExtents, windBox } from './tree-extent.ts';
import { branchMaterials, disposeMaterials, leafMaterials, type MaterialSet } from './tree-materials.ts';
import {
  barkUniforms,
  type LeafUniforms,
  type LevelUniforms,
  leafUniforms,
  levelUniforms,
  sharedUniforms,
} from './uniforms.ts';

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

type TreeMesh = Mesh<InstancedBufferGeometry>;

interface Level {
  readonly mesh: TreeMesh;
  readonly uniforms: LevelUniforms;
  /** By their form; made when they are first needed. */
  tube: MaterialSet | null;
  ribbon: MaterialSet | null;
  extent: LevelExtent;
  start: number;
  count: number;
  /** Stands for the sectors and bands of the mesh's geometry; 0 for none. Compared for every camera: it allocates nothing. */
  drawn: number;
}

/** The parts of the deformer's programs that a level needs; each that is left out saves work at every vertex. */
function definesOf(level: number, species: Species, paper: boolean): string[] {
  const { taper, lobeDepth, bulgeDepth } = levelShape(species, level);
  const plain = level > 0 && bulgeDepth === 0 && lobeDepth === 0 && taper <= 1;
  return [level === 0 ? 'FLARED' : '', plain ? 'PLAIN_STEM' : '', paper ? 'PAPER_FORMS' : ''].filter(Boolean);
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
  readonly leafLook: LeafUniforms = leafUniforms();
  readonly shown: Shown;
  readonly channelLook = channelUniforms();
  #channel: ChannelView | null = null;
  /** Height of the picture in pixels, for the choice of detail. */
  pictureHeight = 1080;
  #levels: Level[] = [];
  #leafMesh: TreeMesh | null = null;
  #leafMaterials: Partial<Record<'near' | 'far', MaterialSet>> = {};
  /** Leaves of the geometry that the leaf mesh has, 0 for none, and how finely it draws each. */
  #leafDrawn = 0;
  #leafGrain: LeafGrain = 'far';
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
    this.#leafDrawn = 0;
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
    const leaves = shown.leaves && surfaces && shown.mode !== 'levels' && tree.leafCount > 0 && shown.leafBudget > 0;
    if (leaves) this.#fitLeaves(tree, this.#species, camera);
    if (this.#leafMesh) this.#leafMesh.visible = leaves;
    this.#fitLines(tree);
  }

  /** Triangles, draw calls, pieces and leaves of the frame that was drawn last, shadows left out. */
  stats(): { triangles: number; drawCalls: number; pieces: number; leaves: number } {
    const drawn = this.#levels.filter(({ mesh }) => mesh.visible);
    const leaves = this.#leafMesh?.visible ? this.#leafMesh : null;
    const meshes = [...drawn.map(({ mesh }) => mesh), ...(leaves ? [leaves] : [])];
    return {
      triangles: meshes.reduce((sum, { geometry }) => sum + Number(geometry.userData.triangles ?? 0), 0),
      drawCalls: meshes.length + (this.#lines?.visible ? 1 : 0),
      pieces: drawn.reduce((sum, { count }) => sum + count, 0),
      leaves: leaves ? this.leafLook.leafRange.value.x : 0,
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
    for (const set of Object.values(this.#leafMaterials)) disposeMaterials(set);
    this.#leafMaterials = {};
    this.#leafDrawn = 0;
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
    this.#leafMesh?.geometry.dispose();
    for (const set of Object.values(this.#leafMaterials)) disposeMaterials(set);
    this.#lines?.geometry.dispose();
    this.#lines?.material.dispose();
    this.bark.barkMap.value?.dispose();
    this.bark.barkMap.value = null;
    this.channelLook.channelTexels.value?.dispose();
    this.channelLook.channelTexels.value = null;
    this.#leafMesh = null;
    this.#leafMaterials = {};
    this.#lines = null;
    this.clear();
  }

  #meshes(): TreeMesh[] {
    return [...this.#levels.map(({ mesh }) => mesh), ...(this.#leafMesh ? [this.#leafMesh] : [])];
  }

  #addLevel(index: number): Level {
    const uniforms = levelUniforms();
    const mesh = this.#newMesh(`level ${index}`);
    const level: Level = {
      mesh,
      uniforms,
      tube: null,
      ribbon: null,
      extent: { box: mesh.userData.box, radius: 0 },
      start: 0,
      count: 0,
      drawn: 0,
    };
    this.#levels.push(level);
    return level;
  }

  #newMesh(name: string): TreeMesh {
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
    for (const set of [level.tube, level.ribbon]) if (set) disposeMaterials(set);
    Object.assign(level, { tube: null, ribbon: null, drawn: 0 });
  }

  #setShape({ uniforms }: Level, index: number, species: Species): void {
    const { taper, flare, lobes, lobeDepth, lobeFade, bulges, bulgeDepth } = levelShape(species, index);
    const [a, b] = uniforms.stemShape.value as [Vector4, Vector4];
    a.set(taper, flare, lobes, lobeDepth);
    b.set(lobeFade, bulges, bulgeDepth, COLLAR);
  }

  #setLook(tree: PackedTree, { bark, foliage, wind }: Species): void {
    const { shared, leafLook } = this;
    shared.crownCentre.value.fromArray(tree.crown, 0);
    shared.crownRadii.value.fromArray(tree.crown, 3);
    const [low, size] = this.channelLook.channelBox.value as [Vector3, Vector3];
    low.fromArray(tree.bounds, 0);
    size.fromArray(tree.bounds, 3).sub(low);
    const map = this.bark.barkMap;
    if (map.value?.name !== `bark ${bark.kind}`) {
      map.value?.dispose();
      map.value = barkTexture(bark.kind);
    }
    this.bark.barkTile.value = bark.grain * GRAINS_PER_TILE[bark.kind];
    this.bark.barkColour.value.set(bark.colour);
    this.bark.barkDark.value.set(bark.dark);
    this.bark.barkRelief.value = bark.relief;
    for (const { tube, ribbon } of this.#levels) {
      for (const set of [tube, ribbon]) if (set) set.standard.roughness = bark.roughness;
    }
    leafLook.leafColour.value.set(foliage.colour);
    leafLook.leafUnder.value.set(foliage.under);
    leafLook.leafGlow.value.set(foliage.glow);
    leafLook.leafVariation.value = foliage.variation;
    leafLook.leafFlutter.value.x = (wind.flutter * Math.PI) / 180;
    for (const set of Object.values(this.#leafMaterials)) set.standard.roughness = foliage.roughness;
  }

  #fitLevel(level: Level, index: number, camera: Camera): void {
    const { extent, count, mesh, uniforms } = level;
    const pixels = extent.radius * pixelsPerMetre(camera, this.matrixWorld, extent.box, this.pictureHeight);
    const grid = gridDetail(index, pixels, count, this.shown.detail);
    const [a] = uniforms.stemShape.value as [Vector4, Vector4];
    const sectors = sectorsForLobes(grid.sectors, a.z, a.w);
    // The rest of the spec is the tree's: `setTree` forgets what was drawn.
    const drawn = sectors * 256 + grid.bands;
    if (level.drawn === drawn) return;
    // Below 1 the taper leaves the tip open.
    const spec = { sectors, bands: grid.bands, cap: a.x < 1, bundle: bundleFor(count) };
    const made = String(Object.values(spec));
    if (made === mesh.geometry.userData.made) {
      recount(mesh.geometry, count, spec.bundle, this.#box as Box3);
    } else {
      mesh.geometry.dispose();
      mesh.geometry = branchGeometry(spec, count, this.#box as Box3);
      mesh.geometry.userData.made = made;
    }
    uniforms.branchRange.value.set(level.start, count, spec.bundle);
    this.#dress(mesh, this.#branchSet(level, index, spec.sectors === 1 ? 'ribbon' : 'tube'));
    level.drawn = drawn;
  }

  #branchSet(level: Level, index: number, form: 'tube' | 'ribbon'): MaterialSet {
    const made = level[form];
    if (made) return made;
    const species = this.#species as Species;
    const defines = [...definesOf(index, species, this.#paper), ...(form === 'ribbon' ? ['RIBBON'] : [])];
    const set = branchMaterials([...defines, ...this.#viewDefines()], {
      ...this.shared,
      ...this.bark,
      ...this.channelLook,
      ...level.uniforms,
    });
    set.standard.roughness = species.bark.roughness;
    set.standard.wireframe = this.shown.mode === 'wireframe';
    level[form] = set;
    return set;
  }

  #fitLeaves(tree: PackedTree, species: Species, camera: Camera): void {
    const { leaves, foliage } = species;
    const { leafLook, shown } = this;
    const length = tree.leafLength * foliage.size;
    const scale = pixelsPerMetre(camera, this.matrixWorld, this.#box as Box3, this.pictureHeight);
    const count = leavesDrawn(tree.leafCount, length * scale, Math.min(tree.leafCount, shown.leafBudget), shown.detail);
    const [growX, growY] = leafGrowth(count / tree.leafCount, leaves.scaleX);
    const pixels = length * growY * scale;
    const { petiole, scaleX: width } = leaves;
    const shape = foliage.outline ?? leaves.shape;
    const grain = leafGrain(pixels, count, (g) => leafTriangles(shape, petiole, g), shown.detail);
    if (this.#leafDrawn === count && this.#leafGrain === grain) return;
    if (!this.#leafMesh) this.#leafMesh = this.#newMesh('leaves');
    const mesh = this.#leafMesh;
    const spec = { shape, width, petiole, grain };
    const made = String([...Object.values(spec), bundleFor(count)]);
    if (made === mesh.geometry.userData.made) recount(mesh.geometry, count, bundleFor(count), this.#box as Box3);
    else {
      mesh.geometry.dispose();
      mesh.geometry = leafGeometry(spec, count, this.#box as Box3);
      mesh.geometry.userData.made = made;
    }
    leafLook.leafRange.value.set(count, bundleFor(count));
    leafLook.leafSize.value.set(growX * length, growY * length);
    this.#dress(mesh, this.#leafSet(grain === 'near' ? 'near' : 'far', foliage.roughness));
    this.#leafDrawn = count;
    this.#leafGrain = grain;
  }

  #leafSet(kind: 'near' | 'far', roughness: number): MaterialSet {
    let set = this.#leafMaterials[kind];
    if (!set) {
      const defines = [...(kind === 'near' ? ['LEAF_VEINS'] : []), ...this.#viewDefines()];
      set = leafMaterials(defines, { ...this.shared, ...this.channelLook, ...this.leafLook });
      set.standard.roughness = roughness;
      set.standard.wireframe = this.shown.mode === 'wireframe';
      this.#leafMaterials[kind] = set;
    }
    return set;
  }

  #viewDefines(): string[] {
    return this.#channel ? ['CHANNEL_VIEW'] : [];
  }

  #dress(mesh: TreeMesh, set: MaterialSet): void {
    mesh.material = set.standard;
    mesh.customDepthMaterial = set.depth;
    mesh.customDistanceMaterial = set.distance;
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
    this.#levels.forEach(({ tube, ribbon, uniforms }, i) => {
      for (const set of [tube, ribbon]) if (set) set.standard.wireframe = mode === 'wireframe';
      const tint = colourOf(i);
      // A channel stands in place of the tint; its surface is as plain.
      uniforms.levelTint.value.set(tint[0], tint[1], tint[2], mode === 'levels' || this.#channel ? 1 : 0);
    });
    for (const set of Object.values(this.#leafMaterials)) set.standard.wireframe = mode === 'wireframe';
  }
}

import { Color } from 'three';

function colourOf(level: number): [number, number, number] {
  const { r, g, b } = new Color(levelColour(level));
  return [r, g, b];
}
