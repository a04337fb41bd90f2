import { type Camera, DataTexture, Matrix4, RedIntegerFormat, UnsignedIntType, Vector2, Vector3 } from 'three';
import { BUNDLE } from './branch-geometry.ts';

/** Texels in a row of the list; shaders/leaf/vertex.glsl reads it by the same number. */
const ROW = 256;

/** Part of the room that leaves have to move in that a camera may go before the list is made anew. */
const STRAY = 0.25;
/** Cosine of the angle that it may turn, and what that adds to the slope of the sides of its view and to the depth. */
const TURN = Math.cos((2.5 * Math.PI) / 180);
const WIDER = 0.1;
const DEEPER = 0.06;
/** Part of the depth that may have changed. */
const CHANGED = 0.02;

/** Metres that a leaf may be beside the place where it hangs at rest, as seen from where the camera may have gone since. */
const roomOf = (slack: number): number => (1 + 2 * STRAY) * slack;

/** What is to be found. */
export interface NearWish {
  /** Feet of the leaves at rest, 3 a leaf, in the space of the tree; the first `count` of them hang there. */
  readonly points: Float32Array;
  readonly count: number;
  /** Depth up to which a leaf is near, in the camera's space. */
  readonly depth: number;
  /** Metres that wind may move a leaf. */
  readonly slack: number;
  /** How many may be near at most. */
  readonly most: number;
}

/** The places of the leaves that a camera may see near by, as a list for the mesh that draws them finely. */
export class NearLeaves {
  readonly uniforms = {
    leafPlaces: { value: null as DataTexture | null },
    leafRange: { value: new Vector2(0, BUNDLE) },
  };
  #wish: NearWish | null = null;
  #depth = 0;
  #count = 0;
  readonly #eye = new Vector3();
  readonly #forward = new Vector3();
  readonly #view = new Matrix4();
  readonly #lastEye = new Vector3();
  readonly #lastForward = new Vector3();
  readonly #sides = new Vector2();

  /** How many the list holds. */
  get count(): number {
    return this.#count;
  }

  /** Finds them, unless those of last time do; returns the depth up to which they are: less than was wished where there were too many. */
  find(wish: NearWish, camera: Camera, matrixWorld: Matrix4): number {
    const { elements } = camera.projectionMatrix;
    const [right, up] = [elements[0]!, elements[5]!];
    this.#view.copy(matrixWorld).invert().multiply(camera.matrixWorld);
    this.#eye.setFromMatrixPosition(this.#view);
    this.#forward.setFromMatrixColumn(this.#view, 2).normalize().negate();
    const last = this.#wish;
    const stays =
      last !== null &&
      last.points === wish.points &&
      last.count === wish.count &&
      (last.depth === wish.depth || Math.abs(last.depth - wish.depth) <= CHANGED * wish.depth) &&
      this.#sides.x === right &&
      this.#sides.y === up &&
      this.#eye.distanceTo(this.#lastEye) <= STRAY * wish.slack &&
      this.#forward.dot(this.#lastForward) >= TURN;
    if (stays) return this.#depth;
    this.#wish = wish;
    this.#lastEye.copy(this.#eye);
    this.#lastForward.copy(this.#forward);
    this.#sides.set(right, up);
    const scale = matrixWorld.getMaxScaleOnAxis();
    const found = this.#within(wish, wish.depth / scale, Math.hypot(1 / right, 1 / up), elements[15] !== 1);
    this.#depth = found.length > wish.most ? scale * this.#keepNearest(found, wish) : wish.depth;
    this.#store(found);
    return this.#depth;
  }

  dispose(): void {
    this.uniforms.leafPlaces.value?.dispose();
    this.uniforms.leafPlaces.value = null;
    this.#wish = null;
    this.#count = 0;
  }

  /** Places of the leaves that may be seen up to a depth, in the space of the tree, wherever the wind has them; `half`: slope, or place, of the view's corners. */
  #within({ points, count, slack }: NearWish, depth: number, half: number, perspective: boolean): number[] {
    const found: number[] = [];
    const room = roomOf(slack);
    const farthest = (1 + DEEPER) * depth + room;
    const { x, y, z } = this.#eye;
    for (let i = 0; i < count; i++) {
      const along = this.#along(points, i);
      if (along > farthest || along < -room) continue;
      const dx = points[3 * i]! - x;
      const dy = points[3 * i + 1]! - y;
      const dz = points[3 * i + 2]! - z;
      const reach = room + (perspective ? Math.max(0, along) * (half + WIDER) : half);
      if (dx * dx + dy * dy + dz * dz - along * along <= reach * reach) found.push(i);
    }
    return found;
  }

  /** Leaves out what is farthest; returns the depth up to which all are left, in the space of the tree: 0 where that is none. */
  #keepNearest(found: number[], { points, most, slack }: NearWish): number {
    found.sort((i, j) => this.#along(points, i) - this.#along(points, j));
    const depth = (this.#along(points, found[most]!) - roomOf(slack)) / (1 + DEEPER);
    found.length = depth > 0 ? most : 0;
    return Math.max(0, depth);
  }

  /** Metres from the eye to a leaf along the middle of the view. */
  #along(points: Float32Array, i: number): number {
    const { x, y, z } = this.#eye;
    const { x: fx, y: fy, z: fz } = this.#forward;
    return (points[3 * i]! - x) * fx + (points[3 * i + 1]! - y) * fy + (points[3 * i + 2]! - z) * fz;
  }

  #store(places: readonly number[]): void {
    const { leafPlaces, leafRange } = this.uniforms;
    this.#count = places.length;
    leafRange.value.x = places.length;
    const rows = Math.max(1, Math.ceil(places.length / ROW));
    if (!leafPlaces.value || leafPlaces.value.image.height! < rows) {
      leafPlaces.value?.dispose();
      const size = 2 ** Math.ceil(Math.log2(rows));
      const texture = new DataTexture(new Uint32Array(ROW * size), ROW, size, RedIntegerFormat, UnsignedIntType);
      texture.internalFormat = 'R32UI';
      texture.name = 'leaves near by';
      leafPlaces.value = texture;
    }
    (leafPlaces.value.image.data as Uint32Array).set(places);
    leafPlaces.value.needsUpdate = true;
  }
}
