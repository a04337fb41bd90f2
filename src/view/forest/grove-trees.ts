import { type Camera, type DataArrayTexture, Matrix4, Vector3 } from 'three';
import { TREE_LAYERS } from '../../core/pack/layout.ts';
import type { PackedGrove } from '../../core/pack/merge-trees.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { arrayTexture } from '../../gpu/tree-textures.ts';

const eye = new Vector3();
const inverse = new Matrix4();

/** The trees of a grove as shaders read them, and where they are from a camera. */
export class GroveTrees {
  readonly texture: DataArrayTexture;
  readonly count: number;
  readonly log2Width: number;
  readonly #data: Float32Array;
  readonly #place: number;
  readonly #radii: number;
  readonly #turn: number;

  constructor({ trees, treeCount }: PackedGrove) {
    this.texture = arrayTexture(trees, 'trees of a grove');
    this.count = treeCount;
    this.log2Width = Math.log2(trees.width);
    this.#data = trees.data;
    this.#place = layerStart(trees, TREE_LAYERS.PLACE);
    this.#radii = layerStart(trees, TREE_LAYERS.RADII);
    this.#turn = layerStart(trees, TREE_LAYERS.TURN);
  }

  /** Metres from a point of grove space to the nearest tree; within a tenth of its height it is that. */
  distance({ x, y, z }: Vector3): number {
    const data = this.#data;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; i < this.count; i++) {
      const at = this.#place + 4 * i;
      const radii = this.#radii + 4 * i;
      const height = data[at + 3] as number;
      const foot = data[at + 2] as number;
      const dx = x - (data[at] as number);
      const dy = y - (data[at + 1] as number);
      const dz = z - Math.min(Math.max(z, foot), foot + height);
      const wide = 0.8 * Math.max(data[radii] as number, data[radii + 1] as number);
      const away = Math.sqrt(dx * dx + dy * dy + dz * dz) - wide;
      least = Math.min(least, Math.max(away, 0.1 * height));
    }
    return least;
  }

  /** How much of a tree has come in this class, and in the one that is nearer, 0..1; true where it was otherwise. */
  share(index: number, come: number, taken: number): boolean {
    const at = this.#turn + 4 * index + 2;
    const data = this.#data;
    if (data[at] === Math.fround(come) && data[at + 1] === Math.fround(taken)) return false;
    data[at] = come;
    data[at + 1] = taken;
    this.texture.needsUpdate = true;
    return true;
  }

  /** Pixels that a metre takes at the nearest tree, in a picture `height` pixels high; `matrixWorld`: of grove space. */
  pixelsPerMetre(camera: Camera, matrixWorld: Matrix4, height: number): number {
    const { elements } = camera.projectionMatrix;
    const scale = (elements[5] as number) * height * 0.5;
    if (elements[15] === 1) return scale; // orthographic: no distance in it
    eye.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(inverse.copy(matrixWorld).invert());
    return scale / Math.max(this.distance(eye), 1e-3);
  }

  dispose(): void {
    this.texture.dispose();
  }
}
