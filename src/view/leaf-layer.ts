import { type Box3, type Camera, type IUniform, type MeshStandardMaterial, type Object3D, Vector2 } from 'three';
import { leafGrowth } from '../core/look/leaf-growth.ts';
import type { LeafGrain, LeafMesh } from '../core/look/leaf-mesh.ts';
import { BUNDLE, bundleFor, type LeafShadow, leafGeometry, recount } from './branch-geometry.ts';
import type { channelUniforms } from './channel-look.ts';
import { leafGrain, leavesCasting, leavesDrawn, nearDepth, nearMost } from './detail.ts';
import { LIT_AT_CORNERS } from './leaf-shader.ts';
import { ListedLeaves, type ListWish } from './listed-leaves.ts';
import type { TreeKit } from './tree-kit.ts';
import { disposeMaterials, dress, leafMaterials, type MaterialSet } from './tree-materials.ts';
import type { Shown, TreeMesh } from './tree-parts.ts';
import type { LeafUniforms, SharedUniforms } from './uniforms.ts';

/** What the leaves need of the tree that they hang on. */
export interface LeafHost extends Object3D {
  readonly kit: TreeKit;
  readonly shown: Shown;
  readonly shared: SharedUniforms;
  readonly channelLook: ReturnType<typeof channelUniforms>;
  readonly pictureHeight: number;
  /** Trees that are drawn as one. */
  readonly treeCount: number;
  /** Pixels that a metre takes of what is in `box`. */
  scaleOf(camera: Camera, box: Box3): number;
  /** Names that every material of the tree is compiled with. */
  viewDefines(): string[];
  /** A mesh of the tree, without a geometry. */
  newMesh(name: string): TreeMesh;
}

/** What hangs at the first places of the leaves' draw order. */
export interface LeafLike {
  /** Stands for the mesh: equal keys, equal meshes. */
  readonly key: string;
  readonly mesh: (grain: LeafGrain, bundle: number) => LeafMesh;
  readonly triangles: Readonly<Record<LeafGrain, number>>;
  /** How many there are; a coarser picture draws fewer, larger ones. */
  readonly count: number;
  /** Metres that a length of 1 of the mesh stands for. */
  readonly length: number;
  readonly widthOverLength: number;
  readonly roughness: number;
  /** Where they hang at rest, 3 numbers each, in the space of the tree. */
  readonly points: () => Float32Array;
}

/** The leaves that are drawn, as both lists look for them. */
type Hung = Pick<ListWish, 'count' | 'slack' | 'reach'>;
/** Which of them are to be drawn finely. */
type Finely = Pick<ListWish, 'depth' | 'most'>;

/** How many times as high as the picture a tree is of which only what is seen is drawn. */
const PART = 1.25;

/** Depth beyond everything. */
const BEYOND = 1e9;

/** One mesh of a layer, and what it draws now. */
class LeafDraw {
  readonly mesh: TreeMesh;
  readonly leafCut = { value: new Vector2(-BEYOND, BEYOND) };
  /** The places that it draws where it does not draw all. */
  readonly list = new ListedLeaves();
  #sets: { all?: MaterialSet; listed?: MaterialSet } = {};

  constructor(mesh: TreeMesh) {
    this.mesh = mesh;
    // The crown first: it hides most of the wood within it, and the ground behind, which are then not shaded.
    mesh.renderOrder = -1;
  }

  /** Draws `count` copies of a mesh, `made` standing for it; `shadow`: what it is in shadow maps. */
  draw(made: string, mesh: () => LeafMesh, count: number, bundle: number, box: Box3, shadow: LeafShadow | null): void {
    const { geometry } = this.mesh;
    if (made === geometry.userData.made) {
      recount(geometry, count, bundle, box, shadow?.count);
      return;
    }
    geometry.dispose();
    this.mesh.geometry = leafGeometry(mesh(), count, bundle, box, shadow);
    this.mesh.geometry.userData.made = made;
  }

  /** Draws with materials that `make` makes when they are first needed: `listed`, those of the list alone. */
  dress(listed: boolean, make: (defines: readonly string[], uniforms: Record<string, IUniform>) => MaterialSet): void {
    const kind = listed ? 'listed' : 'all';
    this.#sets[kind] ??= make(listed ? ['LEAF_LISTED'] : [], {
      ...(listed ? this.list.uniforms : {}),
      leafCut: this.leafCut,
    });
    dress(this.mesh, this.#sets[kind]);
  }

  /** Changes what it draws with. */
  restyle(change: (material: MeshStandardMaterial) => void): void {
    for (const { standard } of Object.values(this.#sets)) change(standard);
  }

  dropMaterials(): void {
    for (const set of Object.values(this.#sets)) disposeMaterials(set);
    this.#sets = {};
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.list.dispose();
    this.dropMaterials();
  }
}

/** Meshes that draw the same small thing at many places of leaves: the leaves themselves, or what twigs bear besides. */
export class LeafLayer {
  readonly #host: LeafHost;
  readonly #name: string;
  readonly #look: LeafUniforms;
  readonly #defines: Readonly<Record<'near' | 'far', readonly string[]>>;
  /** What shadow maps draw of the same leaves: at any depth. */
  readonly #cast = {
    leafRange: { value: new Vector2() },
    leafSize: { value: new Vector2(1, 1) },
    leafCut: { value: new Vector2(-BEYOND, BEYOND) },
  };
  /** All that are not near, and the shadow of all; those that are near, where there may be any. */
  #far: LeafDraw | null = null;
  #near: LeafDraw | null = null;
  #thing: LeafLike | null = null;
  /** Where its leaves hang, once that was asked for. */
  #points: Float32Array | null = null;
  /** How many the far mesh's geometry has, 0 for none, and how finely it draws each. */
  #drawn = 0;
  #casting = 0;
  #grain: LeafGrain = 'far';

  constructor(
    host: LeafHost,
    name: string,
    look: LeafUniforms,
    defines: Readonly<Record<'near' | 'far', readonly string[]>>,
  ) {
    this.#host = host;
    this.#name = name;
    this.#look = look;
    this.#defines = defines;
  }

  /** The meshes that there are. */
  get meshes(): readonly TreeMesh[] {
    return [this.#far, this.#near].flatMap((draw) => draw?.mesh ?? []);
  }

  /** How many the last frame drew. */
  get count(): number {
    return this.#far?.mesh.visible ? this.#look.leafRange.value.x : 0;
  }

  /** Takes other things to draw; their geometry is made at the next frame. */
  take(thing: LeafLike): void {
    this.#thing = thing;
    this.#points = null;
    this.#drawn = 0;
    const restyle = (material: MeshStandardMaterial): void => {
      material.roughness = thing.roughness;
    };
    for (const draw of [this.#far, this.#near]) draw?.restyle(restyle);
  }

  /** Chooses what is drawn for this camera. `box`: bounds of the tree in any wind. */
  fit(camera: Camera, box: Box3): void {
    const { shown } = this.#host;
    const surfaces = shown.mode !== 'control' && shown.mode !== 'levels';
    const visible = shown.leaves && surfaces && shown.leafBudget > 0 && this.#thing !== null && this.#thing.count > 0;
    if (visible && this.#thing) this.#fitThing(this.#thing, camera, box);
    if (this.#far) this.#far.mesh.visible = visible;
    if (this.#near && !visible) this.#near.mesh.visible = false;
  }

  setWireframe(wireframe: boolean): void {
    const restyle = (material: MeshStandardMaterial): void => {
      material.wireframe = wireframe;
    };
    for (const draw of [this.#far, this.#near]) draw?.restyle(restyle);
  }

  /** Their programs are others: what is drawn next makes them anew. */
  dropMaterials(): void {
    this.#far?.dropMaterials();
    this.#near?.dropMaterials();
    this.#drawn = 0;
  }

  dispose(): void {
    this.#far?.dispose();
    this.#near?.dispose();
    this.#far = null;
    this.#near = null;
  }

  #fitThing(thing: LeafLike, camera: Camera, box: Box3): void {
    const { shown, treeCount } = this.#host;
    const scale = this.#host.scaleOf(camera, box);
    const most = Math.min(thing.count, shown.leafBudget * treeCount);
    const count = leavesDrawn(thing.count, thing.length * scale, most, shown.detail);
    const [growX, growY] = leafGrowth(count / thing.count, thing.widthOverLength);
    const grain = leafGrain(thing.length * growY * scale, count / treeCount, thing.triangles.middle, shown.detail);
    const casting = leavesCasting(count, shown.detail);
    const bundle = bundleFor(count);
    this.#far ??= this.#draw('far');
    if (this.#drawn !== count || this.#grain !== grain || this.#casting !== casting) {
      const castGrain = shown.detail === 'high' ? grain : 'far';
      const shadow = { mesh: thing.mesh(castGrain, bundle), count: casting };
      const made = `${thing.key} ${grain} ${castGrain} ${bundle}`;
      this.#far.draw(made, () => thing.mesh(grain, bundle), count, bundle, box, shadow);
      this.#look.leafRange.value.set(count, bundle);
      this.#look.leafSize.value.set(growX * thing.length, growY * thing.length);
      const [castX, castY] = leafGrowth(casting / thing.count, thing.widthOverLength);
      this.#cast.leafRange.value.set(casting, bundle);
      this.#cast.leafSize.value.set(castX * thing.length, castY * thing.length);
      this.#drawn = count;
      this.#casting = casting;
      this.#grain = grain;
    }
    const finely = this.#finely(thing, growY, camera, scale);
    const height = box.max.z - box.min.z;
    const wish = {
      count,
      // The wind's part as windBox has it; the leaf's as leafShown of shaders/leaf/vertex.glsl.
      slack: 0.1 * height,
      reach: 1.6 * growY * thing.length,
    };
    // Of a tree that the picture shows a part of, only what may be seen is drawn: the rest would cost as much.
    const inPart = treeCount === 1 && (finely !== null || height * scale > PART * this.#host.pictureHeight);
    const far = this.#far;
    const near = finely && this.#nearDraw;
    far.leafCut.value.x = -BEYOND;
    if (inPart) this.#listSeen(far, near, finely, wish, camera);
    else if (finely && near) far.leafCut.value.x = this.#listNear(near, finely, wish, camera);
    far.list.uniforms.leafRange.value.y = bundle;
    const many = inPart ? Math.max(1, far.list.count) : count;
    if (far.mesh.geometry.userData.count !== many) recount(far.mesh.geometry, many, bundle, box, casting);
    this.#dress(far, 'far', inPart);
    if (near && near.list.count > 0) this.#drawNear(near, thing, box);
    else if (this.#near) this.#near.mesh.visible = false;
  }

  get #nearDraw(): LeafDraw {
    this.#near ??= this.#draw('near');
    return this.#near;
  }

  get #places(): Float32Array {
    this.#points ??= (this.#thing as LeafLike).points();
    return this.#points;
  }

  /** Shares out what may be seen: near by what is to be drawn finely, far all else. */
  #listSeen(far: LeafDraw, near: LeafDraw | null, finely: Finely | null, wish: Hung, camera: Camera): void {
    const any = Number.POSITIVE_INFINITY;
    const nearer = near && finely ? { nearer: { ...finely, list: near.list } } : {};
    far.list.find({ ...wish, points: this.#places, depth: any, most: any, ...nearer }, camera, this.#host.matrixWorld);
    if (near) near.leafCut.value.y = BEYOND;
  }

  /** Lists what is near in a grove, whose other leaves are too many to list; returns the depth from which on the far mesh draws. */
  #listNear(near: LeafDraw, finely: Finely, wish: Hung, camera: Camera): number {
    const depth = near.list.find({ ...wish, points: this.#places, ...finely }, camera, this.#host.matrixWorld);
    near.leafCut.value.y = depth;
    return near.list.count > 0 ? depth : -BEYOND;
  }

  /** Up to which depth leaves are to be drawn finely, and how many; null where none is. */
  #finely(thing: LeafLike, growth: number, camera: Camera, nearest: number): Finely | null {
    const { shown, pictureHeight, matrixWorld } = this.#host;
    const { elements } = camera.projectionMatrix;
    // Where there are too many to draw all of them as finely as they should be, those that are near begin farther away.
    const fine = leafGrain(thing.length * growth * nearest, 0, thing.triangles.middle, shown.detail);
    const farther = fine === this.#grain ? 1 : 2;
    const leaf = { length: farther * thing.length * growth, triangles: thing.triangles.near };
    // Mostly no leaf is near, and none is looked for.
    if (nearDepth({ ...leaf, scale: nearest, perspective: false }, shown.detail) === 0) return null;
    const seen = {
      triangles: leaf.triangles,
      length: leaf.length * matrixWorld.getMaxScaleOnAxis(),
      scale: elements[5]! * pictureHeight * 0.5,
      perspective: elements[15] !== 1,
    };
    return { depth: nearDepth(seen, shown.detail), most: nearMost(leaf.triangles, shown.detail) };
  }

  #drawNear(near: LeafDraw, thing: LeafLike, box: Box3): void {
    const { mesh, list } = near;
    const made = `${thing.key} near`;
    if (mesh.geometry.userData.made !== made || mesh.geometry.userData.count !== list.count)
      near.draw(made, () => thing.mesh('near', BUNDLE), list.count, BUNDLE, box, null);
    mesh.visible = true;
    mesh.castShadow = false; // the far mesh casts for all
    this.#dress(near, 'near', true);
  }

  #draw(kind: 'near' | 'far'): LeafDraw {
    return new LeafDraw(this.#host.newMesh(kind === 'near' ? `${this.#name} near by` : this.#name));
  }

  #dress(draw: LeafDraw, kind: 'near' | 'far', listed: boolean): void {
    draw.dress(listed, (defines, uniforms) => {
      const { shared, channelLook, shown } = this.#host;
      const near = kind === 'near' ? ['LEAF_NEAR'] : [];
      const all = [
        'LEAF_CUT',
        ...LIT_AT_CORNERS,
        ...near,
        ...defines,
        ...this.#defines[kind],
        ...this.#host.viewDefines(),
      ];
      const set = leafMaterials(all, { ...shared, ...channelLook, ...this.#look, ...uniforms }, this.#cast);
      set.standard.roughness = (this.#thing as LeafLike).roughness;
      set.standard.wireframe = shown.mode === 'wireframe';
      return set;
    });
  }
}
