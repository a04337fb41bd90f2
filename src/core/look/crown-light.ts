/** Light of the sky within a box of tree space, as a grid whose values stand at the middles of its cells. */
export interface CrownLight {
  /** Cells along each side. */
  readonly cells: number;
  /** Least corner and size of the box, metres. */
  readonly low: readonly [number, number, number];
  readonly size: readonly [number, number, number];
  /** 0..255 for 0..1; x runs fastest, then y. */
  readonly data: Uint8Array<ArrayBuffer>;
}

export const CROWN_CELLS = 20;

/** Leaves are seen at all angles, half of their area on average, and stand in clumps with gaps between. */
const HIDES = 0.5 * 0.62;

/** Light that reaches a leaf by way of others however deep it is. */
const LEAST = 0.16;

/** Directions to the sky and to the lit ground, and what comes from there. */
const DIRECTIONS: readonly (readonly [x: number, y: number, z: number, weight: number])[] = [
  [0, 0, 1, 1],
  ...ring(4, 52, 10, 0.8),
  ...ring(6, 14, 25, 0.42),
  ...ring(3, -40, 0, 0.22),
];
const ALL = DIRECTIONS.reduce((sum, [, , , weight]) => sum + weight, 0);

function ring(count: number, elevation: number, from: number, weight: number): [number, number, number, number][] {
  const up = Math.sin((elevation * Math.PI) / 180);
  const out = Math.cos((elevation * Math.PI) / 180);
  return Array.from({ length: count }, (_, i) => {
    const turn = ((from + (360 / count) * i) * Math.PI) / 180;
    return [out * Math.cos(turn), out * Math.sin(turn), up, weight];
  });
}

/**
 * Light inside a crown of leaves at `points` (3 numbers each, metres, tree space), each standing for `area` square metres: what gets through from
 * the sky, all around and from above most, and a little from the ground. Without leaves it is 1 everywhere.
 */
export function crownLight(points: ArrayLike<number>, area: number, cells = CROWN_CELLS): CrownLight {
  const { low, size } = boxAround(points, cells);
  const density = densityOf(points, area, low, size, cells);
  const sum = new Float32Array(cells ** 3);
  if (points.length > 0 && area > 0) {
    const through = new Float32Array(cells ** 3);
    for (const [x, y, z, weight] of DIRECTIONS) {
      sweep(density, through, [x, y, z], size, cells);
      for (let i = 0; i < sum.length; i++) sum[i]! += (weight / ALL) * through[i]!;
    }
  } else sum.fill(1);
  const data = new Uint8Array(sum.length);
  for (let i = 0; i < sum.length; i++) data[i] = Math.round(255 * (LEAST + (1 - LEAST) * Math.min(1, sum[i]!)));
  return { cells, low, size, data };
}

/** The light at a point, between the cells' middles; outside the box that of its nearest place. As shaders/leaf/crown.glsl has it. */
export function lightAt({ cells, low, size, data }: CrownLight, x: number, y: number, z: number): number {
  const [ix, fx] = cellAt((x - low[0]) / size[0], cells);
  const [iy, fy] = cellAt((y - low[1]) / size[1], cells);
  const [iz, fz] = cellAt((z - low[2]) / size[2], cells);
  let out = 0;
  for (let k = 0; k < 8; k++) {
    const [dx, dy, dz] = [k & 1, (k >> 1) & 1, k >> 2];
    const weight = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
    if (weight > 0) out += weight * data[ix + dx + cells * (iy + dy + cells * (iz + dz))]!;
  }
  return out / 255;
}

/** The cell below a place 0..1 of a side, and how far it is to the next, 0..1. */
function cellAt(place: number, cells: number): [number, number] {
  const at = Math.min(cells - 1, Math.max(0, place * cells - 0.5));
  const i = Math.min(cells - 2, Math.floor(at));
  return [i, at - i];
}

type Corner = [number, number, number];

/** A box around points with a cell to spare on each side, so that its outermost cells are outside the crown. */
function boxAround(points: ArrayLike<number>, cells: number): { low: Corner; size: Corner } {
  const low: Corner = [Infinity, Infinity, Infinity];
  const high: Corner = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const k = (i % 3) as 0 | 1 | 2;
    low[k] = Math.min(low[k], points[i]!);
    high[k] = Math.max(high[k], points[i]!);
  }
  const size: Corner = [1, 1, 1];
  for (const k of [0, 1, 2] as const) {
    if (points.length === 0) [low[k], high[k]] = [0, 1];
    const extent = Math.max(high[k] - low[k], 0.05);
    size[k] = (extent * cells) / (cells - 3);
    low[k] -= (size[k] - extent) / 2;
  }
  return { low, size };
}

/** Square metres of leaves in a cubic metre of each cell; a leaf counts for the eight cells around it, so that none has a hard side. */
function densityOf(points: ArrayLike<number>, area: number, low: Corner, size: Corner, cells: number): Float32Array {
  const out = new Float32Array(cells ** 3);
  const each = area / ((size[0] * size[1] * size[2]) / cells ** 3);
  for (let i = 0; i + 2 < points.length; i += 3) {
    const x = ((points[i]! - low[0]) / size[0]) * cells - 0.5;
    const y = ((points[i + 1]! - low[1]) / size[1]) * cells - 0.5;
    const z = ((points[i + 2]! - low[2]) / size[2]) * cells - 0.5;
    const [ix, iy, iz] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    const [fx, fy, fz] = [x - ix, y - iy, z - iz];
    const at = ix + cells * (iy + cells * iz);
    const [nx, ny, nz] = [1, cells, cells * cells];
    out[at]! += each * (1 - fx) * (1 - fy) * (1 - fz);
    out[at + nx]! += each * fx * (1 - fy) * (1 - fz);
    out[at + ny]! += each * (1 - fx) * fy * (1 - fz);
    out[at + nx + ny]! += each * fx * fy * (1 - fz);
    out[at + nz]! += each * (1 - fx) * (1 - fy) * fz;
    out[at + nx + nz]! += each * fx * (1 - fy) * fz;
    out[at + ny + nz]! += each * (1 - fx) * fy * fz;
    out[at + nx + ny + nz]! += each * fx * fy * fz;
  }
  return out;
}

/**
 * What gets through to every cell from the direction `to`: layer by layer along the axis that lies nearest to it, each cell by what has got
 * through to the four cells of the layer before that the ray passes between.
 */
function sweep(density: Float32Array, through: Float32Array, to: Corner, size: Corner, cells: number): void {
  const slopes = [0, 1, 2].map((k) => (to[k]! / size[k]!) * cells) as Corner;
  const main = [0, 1, 2].reduce((best, k) => (Math.abs(slopes[k]!) > Math.abs(slopes[best]!) ? k : best), 0);
  const [a, b] = [(main + 1) % 3, (main + 2) % 3];
  const stride = [1, cells, cells * cells];
  const [alongA, alongB] = [stride[a]!, stride[b]!];
  const step = 1 / Math.abs(slopes[main]!);
  const back = slopes[main]! > 0 ? 1 : -1;
  const [da, db] = [slopes[a]! * step, slopes[b]! * step];
  const [ia, ib] = [Math.floor(da), Math.floor(db)];
  const [fa, fb] = [da - ia, db - ib];
  const hides = (HIDES * step) / 2;
  for (let n = 0; n < cells; n++) {
    const layer = back > 0 ? cells - 1 - n : n;
    const before = (layer + back) * stride[main]!;
    for (let j = 0; j < cells; j++) {
      for (let i = 0; i < cells; i++) {
        const here = layer * stride[main]! + i * alongA + j * alongB;
        let light = 0;
        let dense = 0;
        for (let k = 0; k < 4; k++) {
          const ka = i + ia + (k & 1);
          const kb = j + ib + (k >> 1);
          const weight = (k & 1 ? fa : 1 - fa) * (k >> 1 ? fb : 1 - fb);
          // Beyond the box there are no leaves.
          if (n === 0 || ka < 0 || kb < 0 || ka >= cells || kb >= cells) light += weight;
          else {
            const from = before + ka * alongA + kb * alongB;
            light += weight * through[from]!;
            dense += weight * density[from]!;
          }
        }
        through[here] = light * Math.exp(-hides * (dense + density[here]!));
      }
    }
  }
}
