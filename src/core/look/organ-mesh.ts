import type { OrganKind } from '../species/species.ts';
import { axisBlade } from './blade.ts';
import { addBlade, bundled, type LeafMesh, type MeshBuilder, meshBuilder } from './form-mesh.ts';
import type { HalfOutline, LeafGrain } from './leaf-outline.ts';

/** A ring of a turned body: where on the axis, its radius, and the part of the second colour there. */
type Ring = readonly [z: number, radius: number, second: number];

const PETAL: HalfOutline = [
  [0, 0],
  [0.42, 0.42],
  [0.48, 0.74],
  [0.2, 1],
  [0, 0.93],
];

/** A blossom from afar, covering as much as its petals do seen from above. */
const DISC = [
  [-0.55, 0],
  [0, -0.55],
  [0.55, 0],
  [0, 0.55],
] as const;

/** Bodies as rings from foot to tip, for few and for many sides. Lengths: blossom and fruit across, cone and catkin along. */
const STALK = 0.28;
const FRUIT: readonly Ring[] = [
  [STALK, 0, 1],
  [STALK + 0.1, 0.32, 0],
  [STALK + 0.36, 0.5, 0],
  [STALK + 0.68, 0.44, 0],
  [STALK + 0.93, 0.2, 0],
  [STALK + 0.9, 0, 1],
];

/** A body with scales: rings of edges and gaps in turn, within a spindle. */
function scaly(rows: number, radius: number, rough: number): Ring[] {
  const out: Ring[] = [[0, 0, 1]];
  for (let i = 0; i < 2 * rows; i++) {
    const z = (i + 0.7) / (2 * rows + 0.6);
    const spindle = radius * Math.sin(Math.PI * (0.1 + 0.84 * z) ** 0.8);
    out.push([z, spindle * (i % 2 === 0 ? 1 : 1 - rough), i % 2 === 0 ? 0 : 1]);
  }
  return [...out, [1, 0, 0.3]];
}

/** A double cone for the distance. */
const spindle = (foot: number, radius: number): Ring[] => [
  [foot, 0, 0.3],
  [foot + 0.45 * (1 - foot), radius, 0.2],
  [1, 0, 0.3],
];

type Body = Readonly<Record<LeafGrain, { readonly rings: readonly Ring[]; readonly sides: number }>>;

const BODIES: Readonly<Record<'fruit' | 'cone' | 'catkin', Body>> = {
  fruit: {
    near: { rings: FRUIT, sides: 8 },
    middle: {
      rings: [
        [STALK, 0, 0.3],
        [STALK + 0.3, 0.5, 0],
        [STALK + 0.76, 0.42, 0],
        [STALK + 0.98, 0, 0.2],
      ],
      sides: 5,
    },
    far: {
      rings: [
        [STALK, 0, 0],
        [STALK + 0.5, 0.56, 0],
        [STALK + 1, 0, 0],
      ],
      sides: 3,
    },
  },
  cone: {
    near: { rings: scaly(5, 0.21, 0.3), sides: 7 },
    middle: { rings: scaly(2, 0.2, 0.16), sides: 4 },
    far: { rings: spindle(0, 0.24), sides: 3 },
  },
  catkin: {
    near: { rings: scaly(6, 0.075, 0.28), sides: 5 },
    middle: {
      rings: [
        [0, 0, 0.3],
        [0.15, 0.07, 0.2],
        [0.75, 0.07, 0.3],
        [1, 0, 0.3],
      ],
      sides: 3,
    },
    far: { rings: spindle(0, 0.1), sides: 3 },
  },
};

/** One organ, repeated: as LeafMesh has leaves, but `blade` begins with the part of the second colour. Outer faces are counter-clockwise. Throws RangeError for 'none'. */
export function organMesh(kind: OrganKind, grain: LeafGrain, bundle: number): LeafMesh {
  if (kind === 'none') throw new RangeError('organMesh: there is no mesh of no organ.');
  const one = meshBuilder();
  if (kind === 'blossom') addBlossoms(one, grain);
  else {
    const { rings, sides } = BODIES[kind][grain];
    addBody(one, rings, sides);
    if (kind === 'fruit' && grain === 'near') addStalk(one, STALK);
  }
  return bundled(one, bundle);
}

/** Triangles of one organ. */
export const organTriangles = (kind: OrganKind, grain: LeafGrain): number => organMesh(kind, grain, 1).trianglesPerCopy;

/** Blossoms stand in threes, as cherries and apples have them: how far each leans from the stalk, about it, and how far out it opens. */
const CLUSTER = [
  [16, 40, 0.62],
  [44, 165, 0.54],
  [50, 285, 0.58],
] as const;

/** Three cups of five petals, each 1 across, at the ends of their stalks. */
function addBlossoms(out: MeshBuilder, grain: LeafGrain): void {
  for (const [lean, around, reach] of CLUSTER) {
    const from = out.position.length / 3;
    addBlossom(out, grain, reach);
    lay(out, from, (lean * Math.PI) / 180, (around * Math.PI) / 180);
  }
}

/** Turns the vertices from `from` on by `lean` away from the z axis, towards `around`. */
function lay({ position, normal }: MeshBuilder, from: number, lean: number, around: number): void {
  const [cl, sl, ca, sa] = [Math.cos(lean), Math.sin(lean), Math.cos(around), Math.sin(around)];
  for (const array of [position, normal]) {
    for (let k = 3 * from; k < array.length; k += 3) {
      const [x, y, z] = [array[k]!, array[k + 1]!, array[k + 2]!];
      const out = cl * x + sl * z;
      array[k] = ca * out - sa * y;
      array[k + 1] = sa * out + ca * y;
      array[k + 2] = -sl * x + cl * z;
    }
  }
}

/** A cup of five petals around the z axis at a height; from afar a disc of two triangles. */
function addBlossom(out: MeshBuilder, grain: LeafGrain, at: number): void {
  const first = out.position.length / 3;
  if (grain === 'far') {
    for (const [x, y] of DISC) {
      out.position.push(x, y, at + 0.2);
      out.normal.push(0, 0, 1);
      out.blade.push(0.12, 0.5, 0, 0);
    }
    out.index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    return;
  }
  if (grain === 'middle') {
    addTriangles(out, at);
    return;
  }
  const bend = { fold: 0.1, arch: 0, curl: -0.22 };
  for (let i = 0; i < 5; i++) addBlade(out, axisBlade(PETAL, [0.5, 0.56], at, 62, 72 * i, bend), 0);
  // The middle of a blossom is where its petals begin.
  for (let k = first; k < out.position.length / 3; k++) {
    out.blade[4 * k] = Math.max(0, 0.9 - 2.4 * out.blade[4 * k + 1]!);
    out.blade[4 * k + 3] = 0;
  }
  addStalk(out, at);
  // Stamens as a little tuft.
  addBody(
    out,
    [
      [at - 0.01, 0, 1],
      [at + 0.08, 0.05, 1],
      [at + 0.13, 0, 1],
    ],
    3,
  );
}

/** Five petals as a triangle each. */
function addTriangles(out: MeshBuilder, at: number): void {
  const [half, rise] = [0.54, 0.25];
  for (let i = 0; i < 5; i++) {
    const first = out.position.length / 3;
    const turn = (2 * Math.PI * i) / 5;
    for (const [away, radius] of [
      [0, 0],
      [-half, 0.5],
      [half, 0.5],
    ] as const) {
      const [c, s] = [Math.cos(turn + away), Math.sin(turn + away)];
      out.position.push(radius * c, radius * s, at + (radius > 0 ? rise : 0));
      const n = Math.hypot(rise, 0.5);
      out.normal.push((-rise * Math.cos(turn)) / n, (-rise * Math.sin(turn)) / n, 0.5 / n);
      out.blade.push(radius > 0 ? 0 : 0.5, radius, 0, 0);
    }
    out.index.push(first, first + 1, first + 2);
  }
}

/** A thin triangle to the foot of an organ. */
function addStalk(out: MeshBuilder, length: number): void {
  const first = out.position.length / 3;
  for (const [x, z] of [
    [-0.02, 0],
    [0.02, 0],
    [0, length],
  ] as const) {
    out.position.push(x, 0, z);
    out.normal.push(0, 1, 0);
    out.blade.push(1, z, 0, 0);
  }
  out.index.push(first, first + 2, first + 1);
}

/** A body of rings about the z axis; a ring of radius 0 is a point. */
function addBody(out: MeshBuilder, rings: readonly Ring[], sides: number): void {
  const starts: number[] = [];
  rings.forEach(([z, radius, second], n) => {
    starts.push(out.position.length / 3);
    const [before, after] = [rings[Math.max(0, n - 1)]!, rings[Math.min(rings.length - 1, n + 1)]!];
    const [dz, dr] = [after[0] - before[0], after[1] - before[1]];
    const long = Math.hypot(dz, dr);
    for (let i = 0; i < (radius === 0 ? 1 : sides); i++) {
      // Every other ring is turned by half a side: scales stand between scales.
      const turn = (2 * Math.PI * (i + (n % 2) / 2)) / sides;
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      out.position.push(radius * c, radius * s, z);
      if (radius === 0) out.normal.push(0, 0, n === 0 ? -1 : 1);
      else out.normal.push((c * dz) / long, (s * dz) / long, -dr / long);
      out.blade.push(second, z, 0, 0);
    }
  });
  for (let n = 0; n + 1 < rings.length; n++) {
    const [low, high] = [starts[n]!, starts[n + 1]!];
    const [point, end] = [rings[n]![1] === 0, rings[n + 1]![1] === 0];
    for (let i = 0; i < sides; i++) {
      const j = (i + 1) % sides;
      if (point) out.index.push(low, high + j, high + i);
      else if (end) out.index.push(low + i, low + j, high);
      else if (n % 2 === 0) out.index.push(low + i, low + j, high + i, low + j, high + j, high + i);
      else out.index.push(low + i, high + j, high + i, low + i, low + j, high + j);
    }
  }
}
