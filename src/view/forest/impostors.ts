import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DoubleSide,
  DynamicDrawUsage,
  type IUniform,
  Matrix4,
  Mesh,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  MeshStandardMaterial,
  Vector3,
  Vector4,
} from 'three';
import type { ForceField } from '../force-field.ts';
import { inject } from '../inject.ts';
import type { ImpostorAtlas } from './impostor-atlas.ts';
import { type FarTrees, ImpostorCells } from './impostor-cells.ts';
import { IMPOSTOR_DEPTH, IMPOSTOR_STANDARD } from './impostor-shader.ts';

/** The uniforms of shaders/forest/fade.glsl, shared by whoever draws a forest. */
export interface FadeUniforms {
  readonly forestEye: IUniform<Vector3>;
  readonly forestScale: IUniform<number>;
  /** z to w alone is read: the band of heights in pixels over which a nearer class takes over. x and y: -1, 0. */
  readonly forestFade: IUniform<Vector4>;
}

/** All far trees of a forest. */
export interface ImpostorTrees extends FarTrees {
  /** Radians from x to y. */
  readonly turn: ArrayLike<number>;
  /** Layer of the atlas that each shows. */
  readonly layer: ArrayLike<number>;
  /** Part of the size of the layer's tree; left out: 1. */
  readonly size?: ArrayLike<number>;
}

/** Side of a cell, metres; cells nearer than `KEEP` are drawn though they are out of sight: their shadows are not. */
const CELL = 64;
const KEEP = 90;

/** Alpha above which a texel is drawn: a little below what its coverage asks for, since the mean of three views is less steep. */
const CUT = 0.47;

/** Numbers a vertex in each of the two attributes. */
const FOUR = 4;

const eye = new Vector3();
const view = new Matrix4();
const inverse = new Matrix4();

/**
 * All far trees of a forest in one draw: quads that show baked pictures of their trees, lit, swaying, and with shadows.
 *
 * It belongs into an object whose space is that of the forest (metres, z up). `update` before each frame chooses what is drawn; trees
 * whose layer is not ready must be kept away by `setThere`.
 */
export class Impostors extends Mesh<BufferGeometry, MeshStandardMaterial> {
  readonly isImpostors = true;
  readonly #atlas: ImpostorAtlas;
  readonly #field: ForceField;
  readonly #views = { value: new Vector4() };
  readonly #meanForce: IUniform<number>;
  #cells: ImpostorCells | null = null;
  /** Indices of all trees in the order of the cells; what is drawn is copied from it. */
  #all = new Uint32Array(0);
  #drawn = 0;
  readonly #seen = new Matrix4();
  #stale = true;
  readonly #take = (start: number, count: number): void => {
    const index = this.geometry.index as BufferAttribute;
    (index.array as Uint32Array).set(this.#all.subarray(6 * start, 6 * (start + count)), 6 * this.#drawn);
    this.#drawn += count;
  };

  constructor(atlas: ImpostorAtlas, field: ForceField, fade: FadeUniforms, meanForce: IUniform<number> = { value: 1 }) {
    const material = new MeshStandardMaterial({ metalness: 0, roughness: 0.75, side: DoubleSide, alphaTest: CUT });
    super(new BufferGeometry(), material);
    this.#atlas = atlas;
    this.#field = field;
    this.#meanForce = meanForce;
    this.#views.value.set(atlas.views, atlas.size, 1, 0);
    const depth = new MeshDepthMaterial({ side: DoubleSide, alphaTest: CUT });
    const distance = new MeshDistanceMaterial({ side: DoubleSide, alphaTest: CUT });
    const uniforms = {
      ...field.uniforms,
      forestEye: fade.forestEye,
      forestScale: fade.forestScale,
      forestFade: fade.forestFade,
      farViews: this.#views,
      farColours: { value: atlas.colours },
      farShapes: { value: atlas.shapes },
      farTable: { value: atlas.table },
    };
    inject(material, 'windgrove impostor', IMPOSTOR_STANDARD, uniforms);
    inject(depth, 'windgrove impostor depth', IMPOSTOR_DEPTH, uniforms);
    inject(distance, 'windgrove impostor distance', IMPOSTOR_DEPTH, uniforms);
    this.customDepthMaterial = depth;
    this.customDistanceMaterial = distance;
    for (const each of [material, depth, distance]) field.dress(each);
    this.name = 'far trees';
    this.castShadow = true;
    this.receiveShadow = true;
    this.frustumCulled = false;
    this.raycast = () => {};
  }

  /** Takes the trees; all of them are there, and none that is nearer. */
  setTrees(trees: ImpostorTrees): void {
    const { count, x, y, z, turn, layer, size } = trees;
    let tall = 0;
    let wide = 0;
    for (let i = 0; i < count; i++) {
      const facts = this.#atlas.facts(layer[i] as number);
      const scale = size ? (size[i] as number) : 1;
      tall = Math.max(tall, scale * (facts?.height ?? 30) * 1.1);
      wide = Math.max(wide, scale * (facts?.halfWidth ?? 15) * 1.3);
    }
    const cells = new ImpostorCells(trees, tall, wide, CELL);
    this.#cells = cells;
    const place = new Float32Array(FOUR * 4 * count);
    const look = new Float32Array(FOUR * 4 * count);
    this.#all = new Uint32Array(6 * count);
    cells.order.forEach((i, k) => {
      for (let corner = 0; corner < 4; corner++) {
        const at = FOUR * (4 * k + corner);
        place.set([x[i] as number, y[i] as number, z[i] as number, size ? (size[i] as number) : 1], at);
        look.set([turn[i] as number, layer[i] as number, 1, 0], at);
      }
      const v = 4 * k;
      this.#all.set([v, v + 1, v + 2, v + 2, v + 1, v + 3], 6 * k);
    });
    this.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('farPlace', new BufferAttribute(place, FOUR));
    geometry.setAttribute('farLook', new BufferAttribute(look, FOUR).setUsage(DynamicDrawUsage));
    geometry.setIndex(new BufferAttribute(this.#all.slice(), 1).setUsage(DynamicDrawUsage));
    this.geometry = geometry;
    this.#stale = true;
  }

  /** How much of tree `i` has come, and how much of what is drawn in its place near by has; 0..1 each. */
  setThere(i: number, own: number, nearer: number): void {
    const slot = this.#cells?.slot[i];
    if (slot === undefined) return;
    const attribute = this.geometry.getAttribute('farLook') as BufferAttribute;
    const { array } = attribute;
    const at = 4 * FOUR * slot;
    if (array[at + 2] === own && array[at + 3] === nearer) return;
    for (let corner = 0; corner < 4; corner++) {
      array[at + FOUR * corner + 2] = own;
      array[at + FOUR * corner + 3] = nearer;
    }
    attribute.addUpdateRange(at, 4 * FOUR);
    attribute.needsUpdate = true;
  }

  /** The layer of the atlas that tree `i` shows from now on. */
  setLayer(i: number, layer: number): void {
    const slot = this.#cells?.slot[i];
    if (slot === undefined) return;
    const attribute = this.geometry.getAttribute('farLook') as BufferAttribute;
    const { array } = attribute;
    const at = 4 * FOUR * slot;
    if (array[at + 1] === layer) return;
    for (let corner = 0; corner < 4; corner++) array[at + FOUR * corner + 1] = layer;
    attribute.addUpdateRange(at, 4 * FOUR);
    attribute.needsUpdate = true;
  }

  /** Chooses what is drawn for this camera, whose and whose forest's world matrices are up to date, in the wind of the field. */
  update(camera: Camera): void {
    for (const each of [this.material, this.customDepthMaterial, this.customDistanceMaterial]) {
      if (each) this.#field.dress(each);
    }
    this.#views.value.z = this.#field.state.softness;
    this.#views.value.w = this.#meanForce.value;
    if (!this.#cells) return;
    this.updateWorldMatrix(true, false);
    view.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).multiply(this.matrixWorld);
    if (!this.#stale && this.#seen.equals(view)) return;
    this.#stale = false;
    this.#seen.copy(view);
    eye.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(inverse.copy(this.matrixWorld).invert());
    this.#drawn = 0;
    this.#cells.visit(view, eye, KEEP, this.#take);
    const index = this.geometry.index as BufferAttribute;
    index.clearUpdateRanges();
    index.addUpdateRange(0, 6 * this.#drawn);
    index.needsUpdate = true;
    this.geometry.setDrawRange(0, 6 * this.#drawn);
    this.visible = this.#drawn > 0;
  }

  /** Trees that the last `update` chose. */
  get drawn(): number {
    return this.#drawn;
  }

  /** Bytes of its buffers on the GPU; the atlas counts its own. */
  get bytes(): number {
    const { attributes, index } = this.geometry;
    return [...Object.values(attributes), index].reduce((sum, each) => sum + (each ? each.array.byteLength : 0), 0);
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.customDepthMaterial?.dispose();
    this.customDistanceMaterial?.dispose();
  }
}
