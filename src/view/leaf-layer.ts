import { type Box3, type Camera, type Object3D, Vector2 } from 'three';
import type { LeafGrain, LeafMesh } from '../core/look/leaf-mesh.ts';
import { bundleFor, leafGeometry, recount } from './branch-geometry.ts';
import type { channelUniforms } from './channel-texels.ts';
import { leafGrain, leafGrowth, leavesCasting, leavesDrawn, showsVeins } from './detail.ts';
import { disposeMaterials, dress, leafMaterials, type MaterialSet } from './tree-materials.ts';
import type { Shown, TreeMesh } from './tree-parts.ts';
import type { LeafUniforms, SharedUniforms } from './uniforms.ts';

/** What the leaves need of the tree that they hang on. */
export interface LeafHost extends Object3D {
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
}

/** A mesh that draws the same small thing at many places of leaves: the leaves themselves, or what twigs bear besides. */
export class LeafLayer {
  readonly #host: LeafHost;
  readonly #name: string;
  readonly #look: LeafUniforms;
  readonly #defines: Readonly<Record<'near' | 'far', readonly string[]>>;
  /** What shadow maps draw of the same leaves. */
  readonly #cast = { leafRange: { value: new Vector2() }, leafSize: { value: new Vector2(1, 1) } };
  #mesh: TreeMesh | null = null;
  #materials: Partial<Record<'near' | 'far', MaterialSet>> = {};
  #thing: LeafLike | null = null;
  /** How many the mesh's geometry has, 0 for none, and how finely it draws each. */
  #drawn = 0;
  #casting = 0;
  #grain: LeafGrain = 'far';
  #kind: 'near' | 'far' = 'far';

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

  get mesh(): TreeMesh | null {
    return this.#mesh;
  }

  /** How many the last frame drew. */
  get count(): number {
    return this.#mesh?.visible ? this.#look.leafRange.value.x : 0;
  }

  /** Takes other things to draw; their geometry is made at the next frame. */
  take(thing: LeafLike): void {
    this.#thing = thing;
    this.#drawn = 0;
    for (const set of Object.values(this.#materials)) set.standard.roughness = thing.roughness;
  }

  /** Chooses what is drawn for this camera. `box`: bounds of the tree in any wind. */
  fit(camera: Camera, box: Box3): void {
    const { shown } = this.#host;
    const surfaces = shown.mode !== 'control' && shown.mode !== 'levels';
    const visible = shown.leaves && surfaces && shown.leafBudget > 0 && this.#thing !== null && this.#thing.count > 0;
    if (visible && this.#thing) this.#fitThing(this.#thing, camera, box);
    if (this.#mesh) this.#mesh.visible = visible;
  }

  setWireframe(wireframe: boolean): void {
    for (const set of Object.values(this.#materials)) set.standard.wireframe = wireframe;
  }

  /** Their programs are others: what is drawn next makes them anew. */
  dropMaterials(): void {
    for (const set of Object.values(this.#materials)) disposeMaterials(set);
    this.#materials = {};
    this.#drawn = 0;
  }

  dispose(): void {
    this.#mesh?.geometry.dispose();
    this.dropMaterials();
    this.#mesh = null;
  }

  #fitThing(thing: LeafLike, camera: Camera, box: Box3): void {
    const { shown, treeCount } = this.#host;
    const scale = this.#host.scaleOf(camera, box);
    const most = Math.min(thing.count, shown.leafBudget * treeCount);
    const count = leavesDrawn(thing.count, thing.length * scale, most, shown.detail);
    const [growX, growY] = leafGrowth(count / thing.count, thing.widthOverLength);
    const pixels = thing.length * growY * scale;
    const grain = leafGrain(pixels, count / treeCount, (g) => thing.triangles[g], shown.detail);
    // Where there are too many leaves for the finest grain they are near all the same.
    const kind = showsVeins(pixels, shown.detail) ? 'near' : 'far';
    const casting = leavesCasting(count, shown.detail);
    if (this.#drawn === count && this.#grain === grain && this.#kind === kind && this.#casting === casting) return;
    this.#mesh ??= this.#host.newMesh(this.#name);
    const mesh = this.#mesh;
    const bundle = bundleFor(count);
    const castGrain = shown.detail === 'high' ? grain : 'far';
    const made = `${thing.key} ${grain} ${castGrain} ${bundle}`;
    if (made === mesh.geometry.userData.made) recount(mesh.geometry, count, bundle, box, casting);
    else {
      mesh.geometry.dispose();
      mesh.geometry = leafGeometry(thing.mesh(grain, bundle), count, bundle, box, {
        mesh: thing.mesh(castGrain, bundle),
        count: casting,
      });
      mesh.geometry.userData.made = made;
    }
    this.#look.leafRange.value.set(count, bundle);
    this.#look.leafSize.value.set(growX * thing.length, growY * thing.length);
    const [castX, castY] = leafGrowth(casting / thing.count, thing.widthOverLength);
    this.#cast.leafRange.value.set(casting, bundle);
    this.#cast.leafSize.value.set(castX * thing.length, castY * thing.length);
    dress(mesh, this.#set(kind, thing.roughness));
    this.#drawn = count;
    this.#casting = casting;
    this.#grain = grain;
    this.#kind = kind;
  }

  #set(kind: 'near' | 'far', roughness: number): MaterialSet {
    const made = this.#materials[kind];
    if (made) return made;
    const { shared, channelLook, shown } = this.#host;
    const defines = [...this.#defines[kind], ...this.#host.viewDefines()];
    const set = leafMaterials(defines, { ...shared, ...channelLook, ...this.#look }, this.#cast);
    set.standard.roughness = roughness;
    set.standard.wireframe = shown.mode === 'wireframe';
    this.#materials[kind] = set;
    return set;
  }
}
