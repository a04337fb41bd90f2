import type { StemTable } from '../pack/stem-table.ts';
import { halfBits } from './half.ts';

/** The shader of Unreal that reads these textures follows a place up to three parents, and its index has 15 bits. */
export const MOST_DEPTH = 3;
export const MOST_ELEMENTS = 30_000;

/** The widest texture of elements that a row is given; each is at a texel of its own. */
const WIDEST = 256;

/** Added to an index, so that its bits are never those of a denormal half, which some hardware flushes to nothing. */
export const INDEX_BIAS = 1024;

/** The largest extent that eight bits in steps of eight centimetres can say. */
const MOST_EXTENT = 2048;

/** The elements of a tree: what an engine turns each about its own pivot. */
export interface PivotElements {
  readonly count: number;
  /** Element of each stem: its own, or that of the stem on which it rides. */
  readonly ofStem: Int32Array;
  /** Stem of each element, and the element on which it grows: itself for a root. */
  readonly stem: Int32Array;
  readonly parent: Int32Array;
  readonly width: number;
  readonly height: number;
}

const nextPower = (n: number): number => {
  let power = 1;
  while (power < n) power *= 2;
  return power;
};

/**
 * Which stems are elements: those of the first `levels` levels with at most three parents above, as many levels as stay below 30 000.
 * What is no element rides on the nearest stem below it that is.
 */
export function pivotElements(
  { count, level, parent }: Pick<StemTable, 'count' | 'level' | 'parent'>,
  levels: number,
): PivotElements {
  for (let most = Math.min(levels, MOST_DEPTH + 1); ; most--) {
    const ofStem = new Int32Array(count);
    const stem: number[] = [];
    const above: number[] = [];
    const depth: number[] = [];
    for (let i = 0; i < count; i++) {
      const p = parent[i]! < 0 ? -1 : ofStem[parent[i]!]!;
      if (p >= 0 && (level[i]! >= most || depth[p]! >= MOST_DEPTH)) {
        ofStem[i] = p;
        continue;
      }
      ofStem[i] = stem.length;
      above.push(p < 0 ? stem.length : p);
      depth.push(p < 0 ? 0 : depth[p]! + 1);
      stem.push(i);
    }
    if (stem.length > MOST_ELEMENTS && most > 1) continue;
    const width = Math.min(WIDEST, nextPower(Math.ceil(Math.sqrt(stem.length))));
    const height = nextPower(Math.ceil(stem.length / width));
    return { count: stem.length, ofStem, stem: Int32Array.from(stem), parent: Int32Array.from(above), width, height };
  }
}

/** Texture place of an element: the middle of its texel, u from the left and v from the top, 0..1. */
export const pivotUv = ({ width, height }: PivotElements, element: number): [u: number, v: number] => [
  ((element % width) + 0.5) / width,
  (Math.floor(element / width) + 0.5) / height,
];

/** A point of tree space in Unreal's centimetres: left-handed, z up, y turned about, as its glTF importer turns our files. */
export const unrealPoint = (x: number, y: number, z: number): [number, number, number] => [100 * x, -100 * y, 100 * z];

/**
 * The first texture: the pivot of each element in centimetres, and in alpha the index of its parent as the bits of a half.
 *
 * `Uint16Array`, 4 width height, bits of halves, rows from the top; texels of no element are roots at the origin. Source: Epic's pages on
 * Pivot Painter 2 ("Parent Index (Int as float)"); see docs/wind-channels.md.
 */
export function pivotTexture(elements: PivotElements, stems: Pick<StemTable, 'base'>): Uint16Array {
  const { width, height, count, stem, parent } = elements;
  const bits = new Uint16Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    bits[4 * i + 3] = (i < count ? parent[i]! : Math.min(i, MOST_ELEMENTS)) + INDEX_BIAS;
    if (i >= count) continue;
    const b = 3 * stem[i]!;
    unrealPoint(stems.base[b]!, stems.base[b + 1]!, stems.base[b + 2]!).forEach((part, k) => {
      bits[4 * i + k] = halfBits(part);
    });
  }
  return bits;
}

/**
 * The second texture: the direction from the base of each element to its tip, and in alpha how far that is.
 *
 * `Uint8Array`, 4 width height: -1..1 as 0..255, and the extent in steps of 8 cm from 1 to 256 as 0..255 of 1/256 each.
 */
export function axisTexture(elements: PivotElements, stems: Pick<StemTable, 'base' | 'tip'>): Uint8Array {
  const { width, height, count, stem } = elements;
  const texels = new Uint8Array(4 * width * height);
  for (let i = 0; i < count; i++) {
    const s = 3 * stem[i]!;
    const axis = unrealPoint(
      stems.tip[s]! - stems.base[s]!,
      stems.tip[s + 1]! - stems.base[s + 1]!,
      stems.tip[s + 2]! - stems.base[s + 2]!,
    );
    const extent = Math.sqrt(axis[0] ** 2 + axis[1] ** 2 + axis[2] ** 2);
    for (let k = 0; k < 3; k++) {
      const part = extent > 0 ? axis[k]! / extent : k === 2 ? 1 : 0;
      texels[4 * i + k] = Math.round((255 * (part + 1)) / 2);
    }
    const steps = Math.min(Math.max(Math.min(extent, MOST_EXTENT) / 8, 1), 256);
    texels[4 * i + 3] = Math.round((255 * steps) / 256);
  }
  return texels;
}
