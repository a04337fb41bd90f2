import { Box3, Frustum, Matrix4, Vector3 } from 'three';

const matrix = new Matrix4();
const frustum = new Frustum();

/** Where trees stand, forest space: metres, z up. */
export interface FarTrees {
  readonly count: number;
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
  readonly z: ArrayLike<number>;
}

/** Trees by square cells of the ground: a cell is seen or not as a whole, and the nearest is drawn first. */
export class ImpostorCells {
  /** Trees in the order of the cells, a cell's together; and the place of each tree in it. */
  readonly order: Uint32Array;
  readonly slot: Uint32Array;
  readonly #start: Uint32Array;
  readonly #boxes: Box3[];
  readonly #distance: Float64Array;
  readonly #seen: Uint32Array;
  readonly #compare = (a: number, b: number): number => (this.#distance[a] as number) - (this.#distance[b] as number);

  /** `tall`, `wide`: metres that a tree reaches up and to each side. */
  constructor({ count, x, y, z }: FarTrees, tall: number, wide: number, side: number) {
    const key = (i: number): number =>
      (Math.floor((y[i] as number) / side) + 32768) * 65536 + Math.floor((x[i] as number) / side) + 32768;
    const keys = Float64Array.from({ length: count }, (_, i) => key(i));
    this.order = Uint32Array.from({ length: count }, (_, i) => i).sort(
      (a, b) => (keys[a] as number) - (keys[b] as number) || a - b,
    );
    this.slot = new Uint32Array(count);
    const start = [0];
    const boxes: Box3[] = [];
    this.order.forEach((tree, k) => {
      this.slot[tree] = k;
      if (k === 0 || keys[tree] !== keys[this.order[k - 1] as number]) {
        if (k > 0) start.push(k);
        boxes.push(new Box3());
      }
      const box = boxes[boxes.length - 1] as Box3;
      const at = new Vector3(x[tree] as number, y[tree] as number, z[tree] as number);
      box.expandByPoint(at.clone().subScalar(wide));
      box.expandByPoint(at.add(new Vector3(wide, wide, tall)));
    });
    start.push(count);
    this.#start = Uint32Array.from(start);
    this.#boxes = boxes;
    this.#distance = new Float64Array(boxes.length);
    this.#seen = new Uint32Array(boxes.length);
  }

  get count(): number {
    return this.#boxes.length;
  }

  /**
   * Calls `take` with the ranges of `order` that are to be drawn, the nearest cell first. `view`: from forest space to clip space; cells
   * within `keep` metres of the eye count as seen: their shadows may be.
   */
  visit(view: Matrix4, eye: Vector3, keep: number, take: (start: number, count: number) => void): void {
    frustum.setFromProjectionMatrix(matrix.copy(view));
    let n = 0;
    this.#boxes.forEach((box, cell) => {
      const distance = box.distanceToPoint(eye);
      if (distance > keep && !frustum.intersectsBox(box)) return;
      this.#distance[cell] = distance;
      this.#seen[n++] = cell;
    });
    const seen = this.#seen.subarray(0, n).sort(this.#compare);
    for (const cell of seen) {
      const start = this.#start[cell] as number;
      take(start, (this.#start[cell + 1] as number) - start);
    }
  }
}
