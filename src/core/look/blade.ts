import { type HalfOutline, type LeafGrain, outlineArea } from './leaf-outline.ts';

export type Vector = readonly [number, number, number];

/**
 * One piece of a leaf: both halves of an outline, folded along the midrib and bent. Lengths are those of the whole leaf; x across, y out of the
 * upper face, z along.
 */
export interface Blade {
  readonly half: HalfOutline;
  readonly width: number;
  readonly length: number;
  /** Where its base sits. */
  readonly at: Vector;
  /** Direction of its midrib and of its upper face at the base: of length 1, at right angles. */
  readonly along: Vector;
  readonly up: Vector;
  readonly bend: BladeBend;
  /** Points on the midrib between base and tip. */
  readonly ribs: number;
}

/** How a blade leaves its plane: of lengths of the blade. */
export interface BladeBend {
  /** Rise of the halves from the midrib, falling again by `arch` times the distance squared. */
  readonly fold: number;
  readonly arch: number;
  /** How far the tip hangs. */
  readonly curl: number;
}

export const LEAF_BEND: BladeBend = { fold: 0.28, arch: 0.16, curl: 0.16 };
export const FLAT: BladeBend = { fold: 0, arch: 0, curl: 0 };

const RADIANS = Math.PI / 180;

/** A blade that lies in the plane of the leaf, its base at (x, z), turned by degrees from z to x. */
export function flatBlade(
  half: HalfOutline,
  [width, length]: readonly [number, number],
  [x, z]: readonly [number, number],
  turn: number,
  ribs: number,
  bend: BladeBend = LEAF_BEND,
): Blade {
  const along: Vector = [Math.sin(turn * RADIANS), 0, Math.cos(turn * RADIANS)];
  return { half, width, length, at: [x, 0, z], along, up: [0, 1, 0], bend, ribs };
}

/** A blade that leaves the z axis at height z, by `tilt` degrees from it, at `around` degrees about it; it faces the axis. */
export function axisBlade(
  half: HalfOutline,
  [width, length]: readonly [number, number],
  z: number,
  tilt: number,
  around: number,
  bend: BladeBend = FLAT,
): Blade {
  const [ct, st] = [Math.cos(tilt * RADIANS), Math.sin(tilt * RADIANS)];
  const [ca, sa] = [Math.cos(around * RADIANS), Math.sin(around * RADIANS)];
  return {
    half,
    width,
    length,
    at: [0, 0, z],
    along: [st * ca, st * sa, ct],
    up: [-ct * ca, -ct * sa, st],
    bend,
    ribs: 0,
  };
}

/** Area of some blades, as if they were flat. */
export const bladeArea = (blades: readonly Blade[]): number =>
  blades.reduce((sum, { half, width, length }) => sum + outlineArea(half) * width * length, 0);

/** Area of a leaf of a form. */
export const formArea = ({ blades, teeth }: LeafForm, width: number, grain: LeafGrain): number =>
  bladeArea(blades(width, grain)) + (teeth?.(width, grain)?.area ?? 0);

/** `coarse` with blades so wide that they cover as much as those of `near`. */
export function coveringAs(near: readonly Blade[], coarse: readonly Blade[]): readonly Blade[] {
  const factor = bladeArea(near) / bladeArea(coarse);
  return coarse.map((blade) => ({ ...blade, width: blade.width * factor }));
}

/** A mesh in the making. */
export interface MeshBuilder {
  readonly position: number[];
  readonly normal: number[];
  readonly blade: number[];
  readonly index: number[];
}

/** What is no blade of a leaf. */
export interface Teeth {
  readonly area: number;
  readonly triangles: number;
  /** Puts them into a mesh, beyond a petiole. */
  readonly add: (out: MeshBuilder, petiole: number) => void;
}

/** How veins run: a midrib with side veins, ribs that spread from the base, along the blade, or none that shows. */
export type VeinGroup = 'pinnate' | 'palmate' | 'parallel' | 'none';

/** A shape of leaf: the blades of which it is made. */
export interface LeafForm {
  readonly name: string;
  readonly veins: VeinGroup;
  /** Ends of the ribs that spread, (x, z) as in an outline; of palmate leaves. */
  readonly lobes?: readonly (readonly [number, number])[];
  /** How far the stalk reaches into the leaf; 0.05 by default. */
  readonly stalk?: number;
  /** Blades of a leaf `width` times as wide as long. */
  readonly blades: (width: number, grain: LeafGrain) => readonly Blade[];
  /** Needles that stand for blades in a coarser grain; null where there are none. */
  readonly teeth?: (width: number, grain: LeafGrain) => Teeth | null;
}
