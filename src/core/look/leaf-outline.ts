/**
 * Outlines of the paper's leaf shapes (Weber & Penn 1995, 4.9), drawn by Windgrove.
 *
 * Each is the right half, from the base (0, 0) along the margin to the tip (0, 1): x is the distance from the midrib as a
 * fraction of the leaf's whole width (0..0.5), z runs along the midrib. `near` reads at arm's length, `middle` and `far`
 * keep about the same area in few triangles. A leaf of several leaflets places copies of one outline.
 */
export interface LeafShape {
  readonly name: string;
  readonly near: HalfOutline;
  readonly middle: HalfOutline;
  readonly far: HalfOutline;
  readonly leaflets: readonly Leaflet[];
}

/** Points (x, z) of a right half, base first, tip last. */
export type HalfOutline = readonly (readonly [number, number])[];

/** A copy of the outline: where its base sits, its turn about the leaf's normal in degrees, its size. */
export interface Leaflet {
  readonly x: number;
  readonly z: number;
  readonly turn: number;
  readonly size: number;
}

const single: readonly Leaflet[] = [{ x: 0, z: 0, turn: 0, size: 1 }];

/** Index is `leaves.shape` of a species: oval, triangle, 3-lobe oak, 3-lobe maple, 5-lobe maple, 3 leaflets. */
const PAPER: readonly LeafShape[] = [
  {
    name: 'oval',
    near: [
      [0, 0],
      [0.2, 0.04],
      [0.4, 0.18],
      [0.49, 0.37],
      [0.44, 0.58],
      [0.26, 0.79],
      [0.09, 0.93],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.49, 0.25],
      [0.44, 0.66],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.64, 0.42],
      [0, 1],
    ],
    leaflets: single,
  },
  {
    name: 'triangle',
    near: [
      [0, 0],
      [0.28, -0.03],
      [0.5, 0.1],
      [0.42, 0.32],
      [0.26, 0.58],
      [0.1, 0.85],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.5, 0.05],
      [0.33, 0.52],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.57, 0.2],
      [0, 1],
    ],
    leaflets: single,
  },
  {
    name: 'oak, three lobes',
    near: [
      [0, 0],
      [0.1, 0.08],
      [0.2, 0.24],
      [0.4, 0.3],
      [0.5, 0.42],
      [0.42, 0.5],
      [0.22, 0.5],
      [0.17, 0.58],
      [0.3, 0.68],
      [0.32, 0.78],
      [0.18, 0.8],
      [0.08, 0.94],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.12, 0.2],
      [0.48, 0.4],
      [0.2, 0.55],
      [0.28, 0.76],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.5, 0.5],
      [0, 1],
    ],
    leaflets: single,
  },
  {
    name: 'maple, three lobes',
    near: [
      [0, 0],
      [0.16, 0.02],
      [0.24, 0.18],
      [0.36, 0.3],
      [0.5, 0.62],
      [0.36, 0.56],
      [0.2, 0.5],
      [0.22, 0.66],
      [0.14, 0.8],
      [0.05, 0.92],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.3, 0.14],
      [0.5, 0.6],
      [0.24, 0.56],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.47, 0.46],
      [0, 1],
    ],
    leaflets: single,
  },
  {
    name: 'maple, five lobes',
    near: [
      [0, 0],
      [0.14, -0.06],
      [0.38, 0.02],
      [0.3, 0.12],
      [0.24, 0.2],
      [0.38, 0.34],
      [0.5, 0.58],
      [0.36, 0.54],
      [0.18, 0.48],
      [0.22, 0.68],
      [0.12, 0.84],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.38, 0],
      [0.28, 0.24],
      [0.5, 0.57],
      [0.26, 0.58],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.5, 0.4],
      [0, 1],
    ],
    leaflets: single,
  },
  {
    name: 'three leaflets',
    near: [
      [0, 0],
      [0.22, 0.08],
      [0.44, 0.3],
      [0.48, 0.52],
      [0.3, 0.78],
      [0.1, 0.94],
      [0, 1],
    ],
    middle: [
      [0, 0],
      [0.5, 0.32],
      [0.44, 0.68],
      [0, 1],
    ],
    far: [
      [0, 0],
      [0.62, 0.5],
      [0, 1],
    ],
    leaflets: [
      { x: 0, z: 0.38, turn: 0, size: 0.62 },
      { x: 0, z: 0.3, turn: 68, size: 0.52 },
      { x: 0, z: 0.3, turn: -68, size: 0.52 },
    ],
  },
];

/** Index is `leaves.shape` of a species, as LEAF_SHAPES of the parameter table names them. */
export const LEAF_SHAPES: readonly LeafShape[] = [...PAPER, ...Array.from({ length: 14 }, () => PAPER[0]!)];
