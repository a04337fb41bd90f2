import type { LeafGrain } from '../core/look/leaf-mesh.ts';

/** How finely a tree is drawn: by size on screen, or always finer or coarser than that. */
export type Detail = 'auto' | 'high' | 'low';

/** Sectors and bands of a level's grid; sectors 1 is a ribbon that faces the camera. */
export interface GridDetail {
  readonly sectors: number;
  readonly bands: number;
}

/** Factor on sizes in pixels. */
const FACTOR: Record<Detail, number> = { auto: 1, high: 4, low: 0.4 };

/** Least radius in pixels of each step, and its sectors: a polygon's flat sides stay below about a pixel. */
const SECTORS: readonly (readonly [number, number])[] = [
  [300, 48],
  [130, 36],
  [48, 24],
  [24, 16],
  [10, 12],
  [4, 8],
  [3, 6],
];

/** Bands of a piece by level: trunks carry the flare, deeper pieces are short and nearly straight. */
const BANDS: readonly (readonly [near: number, far: number])[] = [
  [18, 12],
  [10, 6],
  [6, 4],
  [4, 2],
];

/** Radius in pixels below which a trunk has no more bands than a branch. */
const SLIGHT = 8;

/**
 * The grid for a level of `pieces` pieces whose stems are `radius` pixels thick on screen.
 *
 * Triangles cost more than the deformer's arithmetic, so thin branches become ribbons of two columns, and where many thick
 * ones would take too many triangles they are drawn as if they were thinner. `slenderness`: how many radii long a piece is; `deep`: the relief
 * of its bark is to stand out.
 */
export function gridDetail(
  level: number,
  radius: number,
  pieces: number,
  detail: Detail,
  slenderness = 1e9,
  deep?: boolean,
): GridDetail {
  const pixels = radius * FACTOR[detail];
  const relief = deep && reliefGrid(pixels, slenderness, RELIEF_TRIANGLES[detail] / pieces);
  if (relief) return relief;
  const grid = gridFor(level, pixels, pieces, slenderness);
  if (grid.sectors === 1 || pieces * grid.sectors * grid.bands * 2 <= STEM_TRIANGLES[detail]) return grid;
  return gridDetail(level, radius / 2, pieces, detail);
}

/** Sectors that follow a relief, and the radius in pixels from which they are worth it. */
const RELIEF_SECTORS: readonly (readonly [least: number, sectors: number])[] = [
  [240, 96],
  [110, 72],
  [0, 48],
];

/** A grid whose cells are about square, as fine as a relief asks for within `triangles` a piece; null where not even the coarsest is. */
function reliefGrid(pixels: number, slenderness: number, triangles: number): GridDetail | null {
  for (const [least, sectors] of RELIEF_SECTORS) {
    const bands = Math.min(160, Math.max(16, 8 * Math.ceil((sectors * slenderness) / (16 * Math.PI))));
    if (pixels >= least && 2 * sectors * bands <= triangles) return { sectors, bands };
  }
  return null;
}

function gridFor(level: number, pixels: number, pieces: number, slenderness: number): GridDetail {
  // The flare of a trunk that is as thin as a branch is a pixel or two: bushes have many of those.
  const as = level === 0 && pixels < SLIGHT ? 1 : level;
  const bands = BANDS[Math.min(as, BANDS.length - 1)] as readonly [number, number];
  const step = SECTORS.find(([least]) => pixels >= least);
  // A trunk stays round: its lobes and its shadow show even where it is thin. Canes, of which there are many, are as branches.
  const sectors = step ? step[1] : level === 0 && pieces < CANES ? 6 : 1;
  const banded = pixels >= 4 ? bands[0] : bands[1];
  if (sectors > 1 || pixels >= 1) return { sectors, bands: banded };
  // A twig less than a pixel thick is some twenty pixels long, a branch twice that: few straight parts follow their curve; one a shorter piece's.
  const parts = level > 1 || pixels < 0.2 ? 2 : 4;
  return { sectors, bands: Math.min(banded, parts, 1 + Math.floor((pixels * slenderness) / STRAIGHT)) };
}

/** Length in pixels below which a thin piece is straight, and that of each of its parts beyond. */
const STRAIGHT = 20;

/** Pieces of trunks from which on they are the canes of a shrub. */
const CANES = 16;

/** Radius in pixels below which stems are drawn as fewer and wider ones, and the part of them that is always drawn. */
const LEAST_STEM = 0.45;
const LEAST_PART = 0.1;

/**
 * How many of `count` stems are drawn that are `radius` pixels thick: all while a pixel sees each of them, then so many that those which remain,
 * widened to cover as much, are `LEAST_STEM` thick; thinner ones would cost as much and break into dots. In steps of an eighth of an octave.
 */
export function stemsDrawn(count: number, radius: number, detail: Detail): number {
  const fraction = (radius * FACTOR[detail]) / LEAST_STEM;
  if (!(fraction < 1)) return count;
  const step = 2 ** (Math.floor(8 * Math.log2(Math.max(1e-6, fraction))) / 8);
  return Math.max(1, Math.ceil(count * Math.max(LEAST_PART, step)));
}

/** Bands of a piece in shadow maps, by level: a ribbon's, which follows the curve and no more. */
const SHADOW_BANDS = [12, 4, 1, 1] as const;

/** Bands of the ribbon that a piece of a level is in shadow maps, drawn with `bands` in the picture. */
export const shadowBands = (level: number, bands: number, detail: Detail): number =>
  detail === 'high' ? bands : Math.min(bands, SHADOW_BANDS[Math.min(level, SHADOW_BANDS.length - 1)] as number);

/** Pixels of a leaf's length, squared, that each of its triangles takes for it to be drawn in a grain: it covers about a third of that. */
const WORTH = { near: 53, middle: 32 } as const;

/** Length in pixels from which on a leaf of so many triangles is drawn in a grain. */
const leastLength = (grain: 'near' | 'middle', triangles: number, detail: Detail): number =>
  Math.sqrt(WORTH[grain] * triangles) / FACTOR[detail];

/**
 * How finely `count` leaves are drawn whose blades are at most `length` pixels long on screen; `each`: triangles of one in the middle grain.
 * Those that are seen near by are drawn finer by themselves, see `nearDepth`.
 */
export function leafGrain(length: number, count: number, each: number, detail: Detail): Exclude<LeafGrain, 'near'> {
  return length >= leastLength('middle', each, detail) && each * count <= FOLIAGE_TRIANGLES[detail] ? 'middle' : 'far';
}

/** A leaf as a camera sees it. */
export interface LeafSeen {
  /** Of its blade, in units of the camera's space. */
  readonly length: number;
  /** Of its finest form. */
  readonly triangles: number;
  /** Pixels of a unit at depth 1, or at any depth where the camera has no perspective. */
  readonly scale: number;
  readonly perspective: boolean;
}

/** The depth, in units of the camera's space, up to which leaves are drawn in their finest form; 0 where none is. */
export function nearDepth({ length, triangles, scale, perspective }: LeafSeen, detail: Detail): number {
  if (nearMost(triangles, detail) === 0) return 0;
  const depth = (length * scale) / leastLength('near', triangles, detail);
  if (perspective) return depth;
  return depth >= 1 ? Number.POSITIVE_INFINITY : 0;
}

/** How many leaves may be drawn in their finest form, of `triangles` each. */
export const nearMost = (triangles: number, detail: Detail): number =>
  Math.floor(NEAR_TRIANGLES[detail] / Math.max(1, triangles));

/** Triangles that one level of stems, and the leaves, may take before a coarser form is chosen. */
const STEM_TRIANGLES: Record<Detail, number> = { auto: 50_000, high: 2_000_000, low: 60_000 };
/** And that the relief of their bark may take. */
const RELIEF_TRIANGLES: Record<Detail, number> = { auto: 70_000, high: 600_000, low: 20_000 };
const FOLIAGE_TRIANGLES: Record<Detail, number> = { auto: 200_000, high: 6_000_000, low: 100_000 };
/** And those that are near, in their finest form. */
const NEAR_TRIANGLES: Record<Detail, number> = { auto: 50_000, high: 4_000_000, low: 0 };

/** Leaves that are drawn at most, by default. */
export const LEAF_BUDGET: Record<Detail, number> = { auto: 36_000, high: 600_000, low: 30_000 };

/** Part of the leaves that are drawn that cast shadows: those that do are grown to cover as much. */
const CASTING: Record<Detail, number> = { auto: 0.25, high: 1, low: 0.2 };

/** Leaves below which all cast shadows: each spot of light tells. */
const ALL_CAST = 1500;

/** How many of `drawn` leaves are drawn into shadow maps. */
export const leavesCasting = (drawn: number, detail: Detail): number =>
  Math.min(drawn, Math.max(ALL_CAST, Math.ceil(drawn * CASTING[detail])));

/** Shortest blade in pixels that is worth a leaf of its own. */
const LEAST_BLADE = 5;

/**
 * How many of `count` leaves are drawn whose blades are `length` pixels long on screen: all while they can be told apart, then
 * so many that those which remain, grown to cover as much, are about `LEAST_BLADE` long. One by one: many that go at once are seen to.
 */
export function leavesDrawn(count: number, length: number, budget: number, detail: Detail): number {
  const fraction = ((length * FACTOR[detail]) / LEAST_BLADE) ** 2;
  return Math.max(1, Math.min(budget, Math.ceil(count * Math.min(1, fraction))));
}
