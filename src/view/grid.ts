import { chordRadius } from './grid-morph.ts';

/** What a unit grid looks like before it is bent along a piece. */
export interface GridSpec {
  /** Columns around the axis, >= 3; 1 makes a ribbon of two columns that the shader turns to the camera. */
  readonly sectors: number;
  /** Bands along the axis, >= 1. */
  readonly bands: number;
  /** Close the end with a fan: needed where the taper leaves the tip open. */
  readonly cap: boolean;
  /** Crowd the rows towards the end: a half sphere there is a small part of a long stem, and would be a cone else. */
  readonly round?: boolean;
  /** Copies of the grid in one instance; each bends along a piece of its own. */
  readonly bundle: number;
  /** Columns of the coarser grid that it is to become; its own by default. */
  readonly coarse?: number;
}

/** A unit grid as attributes of a geometry. */
export interface Grid {
  /** cos theta | sin theta | v; 3 a vertex. A cap's centre has cos = sin = 0; a ribbon has (-1 or 1, 0, v). */
  readonly position: Float32Array;
  /** theta in turns, 0..1 with both ends | copy within the bundle | distance of the coarser grid's side from the axis, 1 at its corners; 3 a vertex. */
  readonly shape: Float32Array;
  readonly index: Uint16Array | Uint32Array;
  /** Of one copy. */
  readonly verticesPerCopy: number;
  readonly trianglesPerCopy: number;
}

/** cos and sin of a column, exact at the quarters; the last column repeats the first, so the seam closes to the bit. */
function columnAngle(column: number, sectors: number): [number, number] {
  const turns = (column % sectors) / sectors;
  const quarter = Math.round(turns * 4);
  if (Math.abs(turns * 4 - quarter) < 1e-12) {
    return [[1, 0, -1, 0][quarter % 4] as number, [0, 1, 0, -1][quarter % 4] as number];
  }
  return [Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns)];
}

/**
 * The grid of bands x sectors that is instanced over the pieces, counter-clockwise seen from outside.
 *
 * Cosine and sine of theta are attributes because software GL's own are wrong by 2e-4, and the bundle is there because an
 * instance costs such a rasteriser far more than a vertex. Throws RangeError on a spec that makes no surface.
 */
export function branchGrid(spec: GridSpec): Grid {
  const { sectors, bands, cap, bundle, round, coarse = 1 } = spec;
  const ribbon = sectors === 1;
  if (!ribbon && sectors < 3) throw new RangeError(`grid: sectors must be 1 or at least 3, found ${sectors}`);
  if (bands < 1 || bundle < 1)
    throw new RangeError(`grid: bands and bundle must be at least 1, found ${bands}, ${bundle}`);
  const columns = sectors + 1;
  const rows = bands + 1;
  const capped = cap && !ribbon;
  const verticesPerCopy = rows * columns + (capped ? columns : 0);
  const trianglesPerCopy = bands * sectors * 2 + (capped ? sectors : 0);
  const vertices = verticesPerCopy * bundle;
  const position = new Float32Array(vertices * 3);
  const shape = new Float32Array(vertices * 3);
  const index =
    vertices > 65535 ? new Uint32Array(trianglesPerCopy * bundle * 3) : new Uint16Array(trianglesPerCopy * bundle * 3);
  let p = 0;
  let i = 0;
  for (let copy = 0; copy < bundle; copy++) {
    const first = copy * verticesPerCopy;
    for (let row = 0; row < rows + (capped ? 1 : 0); row++) {
      for (let column = 0; column < columns; column++) {
        const centre = row === rows;
        const [c, s] = ribbon ? [column * 2 - 1, 0] : columnAngle(column, sectors);
        position[p] = centre ? 0 : c;
        position[p + 1] = centre ? 0 : s;
        const v = row / bands;
        position[p + 2] = centre ? 1 : round ? v * (2 - v) : v;
        shape[p] = column / sectors;
        shape[p + 1] = copy;
        shape[p + 2] = coarse >= 3 ? chordRadius(column / sectors, coarse) : 1;
        p += 3;
      }
    }
    for (let row = 0; row < bands; row++) {
      for (let column = 0; column < sectors; column++) {
        const a = first + row * columns + column;
        index.set([a, a + 1, a + columns + 1, a, a + columns + 1, a + columns], i);
        i += 6;
      }
    }
    if (capped) {
      for (let column = 0; column < sectors; column++) {
        const a = first + bands * columns + column;
        index.set([a, a + 1, a + columns], i);
        i += 3;
      }
    }
  }
  return { position, shape, index, verticesPerCopy, trianglesPerCopy };
}

/** Sectors for a stem with lobes: a multiple of their number with at least four to a lobe, so that each reads as round. */
export function sectorsForLobes(sectors: number, lobes: number, lobeDepth: number): number {
  if (lobeDepth <= 0 || lobes < 1 || sectors < 3) return sectors;
  const n = Math.round(lobes);
  return n * Math.max(4, Math.ceil(sectors / n));
}
