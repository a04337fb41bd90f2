import { type Camera, DataTexture, Matrix4, RedIntegerFormat, UnsignedIntType, Vector2, Vector3, Vector4 } from 'three';
import { BUNDLE } from './branch-geometry.ts';

/** Texels in a row of the list; shaders/leaf/vertex.glsl reads it by the same number. */
const ROW = 256;

/** Part of the room that leaves have to move in that a camera may go before the list is made anew. */
const STRAY = 0.1;
/** Radians that it may turn, and what that may add to the depth, as a part of it. */
const TURN = Math.PI / 180;
const TURNED = Math.cos(TURN);
const DEEPER = 0.06;
/** What such a turn, and as much of a roll, adds to the slope of a side of the view. */
const widerBy = (slope: number): number => TURN * (1 + slope + slope * slope);

/** Part of the depth that may have changed. */
const CHANGED = 0.02;

/** Part of what the wind may move a leaf by that it mostly does. */
const MOSTLY = 0.15;

/** Metres that a leaf may be beside the place where it hangs at rest, as seen from where the camera may have gone since. */
const roomOf = (slack: number): number => (1 + 2 * STRAY) * slack;

/** What is to be found. */
export interface ListWish {
  /** Feet of the leaves at rest, 3 a leaf, in the space of the tree; the first `count` of them hang there. */
  readonly points: Float32Array;
  readonly count: number;
  /** Depth up to which leaves are listed, in the camera's space. */
  readonly depth: number;
  /** Metres that wind may move a leaf. */
  readonly slack: number;
  /** Metres from the foot of a leaf to its tip at most. */
  readonly reach: number;
  /** How many may be listed at most. */
  readonly most: number;
  /** Another list that takes, of those that are found, the nearest up to a depth; this one then has the rest. */
  readonly nearer?: { readonly list: ListedLeaves; readonly depth: number; readonly most: number };
}

/** Are two depths as good as one? */
const alike = (a: number, b: number): boolean => a === b || Math.abs(a - b) <= CHANGED * b;

/** The places of the leaves that a camera may see, up to a depth, as a list for a mesh that draws no others. */
export class ListedLeaves {
  readonly uniforms = {
    leafPlaces: { value: null as DataTexture | null },
    leafRange: { value: new Vector2(0, BUNDLE) },
  };
  #wish: ListWish | null = null;
  #depth = 0;
  #count = 0;
  readonly #eye = new Vector3();
  /** Ways of the camera in the space of the tree, unit vectors. */
  readonly #forward = new Vector3();
  readonly #right = new Vector3();
  readonly #up = new Vector3();
  readonly #view = new Matrix4();
  readonly #lastEye = new Vector3();
  readonly #lastForward = new Vector3();
  readonly #lastUp = new Vector3();
  /** Middle of the view and half its extent, across and up: slopes, or lengths where there is no perspective. */
  readonly #sides = new Vector4();
  readonly #lastSides = new Vector4();

  /** How many the list holds. */
  get count(): number {
    return this.#count;
  }

  /** Finds them, unless those of last time do; returns the depth up to which they are: less than was wished where there were too many. */
  find(wish: ListWish, camera: Camera, matrixWorld: Matrix4): number {
    const { elements } = camera.projectionMatrix;
    const perspective = elements[15] !== 1;
    const scale = matrixWorld.getMaxScaleOnAxis();
    this.#view.copy(matrixWorld).invert().multiply(camera.matrixWorld);
    this.#eye.setFromMatrixPosition(this.#view);
    this.#right.setFromMatrixColumn(this.#view, 0).normalize();
    this.#up.setFromMatrixColumn(this.#view, 1).normalize();
    this.#forward.setFromMatrixColumn(this.#view, 2).normalize().negate();
    // A part of a larger picture has its middle aside.
    const [x, y] = perspective ? [elements[8]!, elements[9]!] : [-elements[12]!, -elements[13]!];
    this.#sides.set(x / elements[0]!, y / elements[5]!, 1 / elements[0]!, 1 / elements[5]!);
    if (!perspective) this.#sides.divideScalar(scale);
    const last = this.#wish;
    const stays =
      last !== null &&
      last.points === wish.points &&
      last.count === wish.count &&
      alike(last.depth, wish.depth) &&
      last.nearer?.list === wish.nearer?.list &&
      alike(last.nearer?.depth ?? 0, wish.nearer?.depth ?? 0) &&
      this.#sides.equals(this.#lastSides) &&
      this.#eye.distanceTo(this.#lastEye) <= STRAY * wish.slack &&
      this.#forward.dot(this.#lastForward) >= TURNED &&
      this.#up.dot(this.#lastUp) >= TURNED;
    if (stays) return this.#depth;
    this.#wish = wish;
    this.#lastEye.copy(this.#eye);
    this.#lastForward.copy(this.#forward);
    this.#lastUp.copy(this.#up);
    this.#lastSides.copy(this.#sides);
    const found = this.#within(wish, wish.depth / scale, perspective);
    this.#depth = found.length > wish.most ? scale * this.#keepNearest(found, wish) : wish.depth;
    const { nearer } = wish;
    this.#store(nearer ? this.#rest(found, { ...wish, nearer }, scale, perspective) : found);
    return this.#depth;
  }

  dispose(): void {
    this.uniforms.leafPlaces.value?.dispose();
    this.uniforms.leafPlaces.value = null;
    this.#wish = null;
    this.#count = 0;
  }

  /** Places of the leaves that may be seen up to a depth, in the space of the tree, wherever the wind has them. */
  #within({ points, count, slack, reach }: ListWish, depth: number, perspective: boolean): number[] {
    const found: number[] = [];
    const room = roomOf(slack) + reach;
    const farthest = (1 + DEEPER) * depth + room;
    const { x, y, z } = this.#eye;
    const { x: rx, y: ry, z: rz } = this.#right;
    const { x: ux, y: uy, z: uz } = this.#up;
    const { x: middleX, y: middleY, z: halfX, w: halfY } = this.#sides;
    const sideX = halfX + (perspective ? widerBy(Math.abs(middleX) + halfX) : 0);
    const sideY = halfY + (perspective ? widerBy(Math.abs(middleY) + halfY) : 0);
    // The sides of the view are aslant: a ball touches them from farther off than its radius.
    const besideX = room * (perspective ? Math.hypot(1, Math.abs(middleX) + sideX) : 1);
    const besideY = room * (perspective ? Math.hypot(1, Math.abs(middleY) + sideY) : 1);
    for (let i = 0; i < count; i++) {
      const along = this.#along(points, i);
      if (along > farthest || along < -room) continue;
      const dx = points[3 * i]! - x;
      const dy = points[3 * i + 1]! - y;
      const dz = points[3 * i + 2]! - z;
      const far = perspective ? Math.max(0, along) : 1;
      const across = dx * rx + dy * ry + dz * rz - far * middleX;
      const over = dx * ux + dy * uy + dz * uz - far * middleY;
      if (Math.abs(across) > besideX + far * sideX) continue;
      if (Math.abs(over) <= besideY + far * sideY) found.push(i);
    }
    return found;
  }

  /** Hands to the nearer list what belongs there, and returns the rest, in the order in which it was found. */
  #rest(
    found: number[],
    wish: ListWish & Required<Pick<ListWish, 'nearer'>>,
    scale: number,
    perspective: boolean,
  ): number[] {
    const { points, slack, nearer } = wish;
    const { list, most } = nearer;
    const depth = nearer.depth / scale;
    // What only a storm would bring into view would take the place of what is there.
    const seen = this.#within({ ...wish, slack: MOSTLY * slack }, depth, perspective);
    const near = seen.filter((i) => this.#along(points, i) < depth);
    if (near.length > most) {
      near.sort((i, j) => this.#along(points, i) - this.#along(points, j));
      near.length = most;
    }
    list.#store(near);
    const taken = new Set(near);
    return taken.size > 0 ? found.filter((i) => !taken.has(i)) : found;
  }

  /** Leaves out what is farthest; returns the depth up to which all are left, in the space of the tree: 0 where that is none. */
  #keepNearest(found: number[], { points, most, slack, reach }: ListWish): number {
    found.sort((i, j) => this.#along(points, i) - this.#along(points, j));
    const depth = (this.#along(points, found[most]!) - roomOf(slack) - reach) / (1 + DEEPER);
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
      texture.name = 'listed leaves';
      leafPlaces.value = texture;
    }
    (leafPlaces.value.image.data as Uint32Array).set(places);
    leafPlaces.value.needsUpdate = true;
  }
}
