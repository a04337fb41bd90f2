import type { TreePlaces } from './forest.ts';

/** Cells of a side at most: a grid of few trees over wide ground has larger cells. */
const MOST = 1024;

/** Finds whether a tree stands near a place: cells over the ground, each with a chain of its trees. */
export class PlaceGrid {
  readonly #size: number;
  readonly #side: number;
  readonly #first: Int32Array;
  readonly #next: Int32Array;
  readonly #places: Pick<TreePlaces, 'x' | 'y'>;

  /** A grid for discs of about `radius` metres over `size` metres that are centred on 0, 0, with the first `count` places in it. */
  constructor(size: number, radius: number, places: Pick<TreePlaces, 'x' | 'y'>, count: number) {
    this.#size = size;
    this.#side = Math.min(MOST, Math.max(1, Math.floor(size / radius)));
    this.#first = new Int32Array(this.#side * this.#side).fill(-1);
    this.#next = new Int32Array(places.x.length).fill(-1);
    this.#places = places;
    for (let i = 0; i < count; i++) this.add(i);
  }

  #cell(metres: number): number {
    return Math.min(this.#side - 1, Math.max(0, Math.floor((metres / this.#size + 0.5) * this.#side)));
  }

  /** Place i of the places takes part from now on. */
  add(i: number): void {
    const cell = this.#cell(this.#places.y[i]!) * this.#side + this.#cell(this.#places.x[i]!);
    this.#next[i] = this.#first[cell]!;
    this.#first[cell] = i;
  }

  /** Whether any place is nearer than `distance` metres. */
  within(x: number, y: number, distance: number): boolean {
    const { x: xs, y: ys } = this.#places;
    const square = distance * distance;
    const east = this.#cell(x + distance);
    const north = this.#cell(y + distance);
    for (let j = this.#cell(y - distance); j <= north; j++) {
      for (let i = this.#cell(x - distance); i <= east; i++) {
        for (let k = this.#first[j * this.#side + i]!; k >= 0; k = this.#next[k]!) {
          const dx = xs[k]! - x;
          const dy = ys[k]! - y;
          if (dx * dx + dy * dy < square) return true;
        }
      }
    }
    return false;
  }
}
