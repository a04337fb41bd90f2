import { type Box3, type Camera, type Object3D, Vector2 } from 'three';
import type { LeafGrain, LeafMesh } from '../core/look/leaf-mesh.ts';
import { BUNDLE, bundleFor, type LeafShadow, leafGeometry, recount } from './branch-geometry.ts';
import type { channelUniforms } from './channel-look.ts';
import { leafGrain, leafGrowth, leavesCasting, leavesDrawn, nearDepth, nearMost } from './detail.ts';
import { NearLeaves } from './near-leaves.ts';
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

/** Depth beyond everything. */
const BEYOND = 1e9;

/** One mesh of a layer, and what it draws now. */
class LeafDraw {
  readonly mesh: TreeMesh;
  readonly leafCut = { value: new Vector2(-BEYOND, BEYOND) };
  set: MaterialSet | null = null;

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

  dropMaterials(): void {
    if (this.set) disposeMaterials(this.set);
    this.set = null;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
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
  readonly #list = new NearLeaves();
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
    for (const draw of [this.#far, this.#near]) if (draw?.set) draw.set.standard.roughness = thing.roughness;
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
    for (const draw of [this.#far, this.#near]) if (draw?.set) draw.set.standard.wireframe = wireframe;
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
    this.#list.dispose();
    this.#far = null;
    this.#near = null;
  }

  #fitThing(thing: LeafLike, camera: Camera, box: Box3): void {
    const { shown, treeCount } = this.#host;
    const scale = this.#host.scaleOf(camera, box);
    const most = Math.min(thing.count, shown.leafBudget * treeCount);
    const count = leavesDrawn(thing.count, thing.length * scale, most, shown.detail);
    const [growX, growY] = leafGrowth(count / thing.count, thing.widthOverLength);
    const grain = leafGrain(thing.length * growY * scale, count / treeCount, (g) => thing.triangles[g], shown.detail);
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
    this.#dress(this.#far, 'far', thing);
    const depth = this.#findNear(thing, growY, camera, scale, count, box);
    this.#far.leafCut.value.x = depth > 0 ? depth : -BEYOND;
    if (depth > 0) this.#drawNear(thing, depth, box);
    else if (this.#near) this.#near.mesh.visible = false;
  }

  /** Finds the leaves that are seen near by; returns the depth up to which they are, 0 where none is. */
  #findNear(thing: LeafLike, growth: number, camera: Camera, nearest: number, count: number, box: Box3): number {
    const { shown, pictureHeight, matrixWorld } = this.#host;
    const { elements } = camera.projectionMatrix;
    // Where there are too many to draw all of them as finely as they should be, those that are near begin farther away.
    const fine = leafGrain(thing.length * growth * nearest, 0, (g) => thing.triangles[g], shown.detail);
    const farther = fine === this.#grain ? 1 : 2;
    const leaf = { length: farther * thing.length * growth, triangles: thing.triangles.near };
    // Mostly no leaf is near, and none is looked for.
    if (nearDepth({ ...leaf, scale: nearest, perspective: false }, shown.detail) === 0) return 0;
    const seen = {
      triangles: leaf.triangles,
      length: leaf.length * matrixWorld.getMaxScaleOnAxis(),
      scale: elements[5]! * pictureHeight * 0.5,
      perspective: elements[15] !== 1,
    };
    this.#points ??= thing.points();
    const wish = {
      points: this.#points,
      count,
      depth: nearDepth(seen, shown.detail),
      slack: 0.1 * (box.max.z - box.min.z), // as windBox has it
      most: nearMost(leaf.triangles, shown.detail),
    };
    const depth = this.#list.find(wish, camera, matrixWorld);
    return this.#list.count > 0 ? depth : 0;
  }

  #drawNear(thing: LeafLike, depth: number, box: Box3): void {
    this.#near ??= this.#draw('near');
    const { mesh, leafCut } = this.#near;
    const { count } = this.#list;
    const made = `${thing.key} near`;
    if (mesh.geometry.userData.made !== made || mesh.geometry.userData.count !== count)
      this.#near.draw(made, () => thing.mesh('near', BUNDLE), count, BUNDLE, box, null);
    leafCut.value.y = depth;
    mesh.visible = true;
    mesh.castShadow = false; // the far mesh casts for all
    this.#dress(this.#near, 'near', thing);
  }

  #draw(kind: 'near' | 'far'): LeafDraw {
    return new LeafDraw(this.#host.newMesh(kind === 'near' ? `${this.#name} near by` : this.#name));
  }

  #dress(draw: LeafDraw, kind: 'near' | 'far', { roughness }: LeafLike): void {
    if (draw.set) return;
    const { shared, channelLook, shown } = this.#host;
    const listed = kind === 'near' ? ['LEAF_LISTED'] : [];
    const defines = ['LEAF_CUT', ...listed, ...this.#defines[kind], ...this.#host.viewDefines()];
    const own = kind === 'near' ? this.#list.uniforms : {};
    const uniforms = { ...shared, ...channelLook, ...this.#look, ...own, leafCut: draw.leafCut };
    draw.set = leafMaterials(defines, uniforms, this.#cast);
    draw.set.standard.roughness = roughness;
    draw.set.standard.wireframe = shown.mode === 'wireframe';
    dress(draw.mesh, draw.set);
  }
}
