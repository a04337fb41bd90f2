import { hashPcg, hashUnit } from '../math/hash.ts';
import type { LeafTriangles } from '../mesh/expand-leaves.ts';
import type { LeafPlacements } from '../mesh/leaf-placements.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import type { StemTable } from '../pack/stem-table.ts';
import type { GlbAttribute } from './glb/primitives.ts';

/** What an engine needs to move a tree of ours by its own shader; each is a number or three for every point of the surface. */
export const WIND_CHANNELS = ['sway', 'coordinate', 'branch', 'phase', 'pivot'] as const;
export type WindChannel = (typeof WIND_CHANNELS)[number];

/**
 * The channels of a tree by stem, from which those of a point follow: `swayAt`, and z, phase and pivot as they stand.
 *
 * `swayBase` (0..1) is the sway of the parent where the stem starts, `swayGain` what the stem adds from there to its tip, `start` the part
 * of the whole length at which it starts (more than 0 for a clone), `phase` in turns, `pivot` the base (3 a stem, metres, tree space).
 */
export interface StemChannels {
  readonly count: number;
  readonly swayBase: Float32Array;
  readonly swayGain: Float32Array;
  readonly start: Float32Array;
  readonly phase: Float32Array;
  readonly pivot: Float32Array;
}

/** The entry of a list by level: levels beyond the last use the last. */
const byLevel = (list: readonly number[], level: number): number => list[Math.min(level, list.length - 1)]!;

/**
 * The channels of every stem of a tree; `stiffness` is that of its species' wind, by level.
 *
 * A stem adds sway as a beam does, by the square of the way from its base, in proportion to its length and to the flexibility of its
 * level (1 over `wind.stiffness`); it starts with the sway of its parent there, so that nothing tears. All of it is divided by the
 * largest sway of a tip. The phase is that of the bark: a hash of the stem's path, a clone's being its twin's. Source: ours.
 */
export function stemChannels(
  stems: Pick<StemTable, 'count' | 'level' | 'parent' | 'parentZ' | 'clone' | 'length' | 'path' | 'base'>,
  stiffness: readonly number[],
): StemChannels {
  const { count, level, parent, parentZ, clone, length, path, base: pivot } = stems;
  const swayBase = new Float32Array(count);
  const swayGain = new Float32Array(count);
  const phase = new Float32Array(count);
  const start = new Float32Array(count);
  let most = 0;
  for (let i = 0; i < count; i++) {
    const p = parent[i]!;
    start[i] = clone[i] ? parentZ[i]! : 0;
    phase[i] = clone[i] ? phase[p]! : hashUnit(hashPcg(path[i]! ^ 0x6261726b));
    swayBase[i] = p < 0 ? 0 : swayOf(swayBase[p]!, swayGain[p]!, start[p]!, parentZ[i]!);
    swayGain[i] = (length[i]! * (1 - start[i]!)) / byLevel(stiffness, level[i]!);
    most = Math.max(most, swayBase[i]! + swayGain[i]!);
  }
  for (let i = 0; i < count && most > 0; i++) {
    swayBase[i] = swayBase[i]! / most;
    swayGain[i] = swayGain[i]! / most;
  }
  return { count, swayBase, swayGain, start, phase, pivot };
}

const swayOf = (base: number, gain: number, start: number, z: number): number => {
  const s = start < 1 ? Math.min(Math.max((z - start) / (1 - start), 0), 1) : 1;
  return base + gain * s * s;
};

/** How much a place of a stem sways, 0 at the foot of the trunk to 1 at the tip that sways most; z is a fraction of the whole length. */
export const swayAt = ({ swayBase, swayGain, start }: StemChannels, stem: number, z: number): number =>
  swayOf(swayBase[stem]!, swayGain[stem]!, start[stem]!, z);

/** Part of a turn by which the hue of a stem's colour goes on from that of the stem before: the golden ratio, so that neighbours differ. */
const HUE_STEP = 0.6180339887498949;

/** A colour of full saturation; hue in turns, red, green and blue 0..1. Each part rises and falls over two thirds of a turn. Twin: shaders/lib/hue.glsl. */
export function hueColour(hue: number): [number, number, number] {
  const part = (shift: number): number => {
    const h = hue + shift - Math.floor(hue + shift);
    return Math.min(Math.max(Math.abs(6 * h - 3) - 1, 0), 1);
  };
  return [part(0), part(2 / 3), part(1 / 3)];
}

/**
 * The colour by which a preview shows a channel at z on a stem, red, green and blue 0..1: `sway` black to red, `coordinate` black to green,
 * `phase` and `branch` as hues, `pivot` as its place in the box of the tree (min x, y, z, max x, y, z; x red, y green, z blue).
 */
export function channelColour(
  channels: StemChannels,
  channel: WindChannel,
  stem: number,
  z: number,
  bounds: ArrayLike<number>,
): [number, number, number] {
  switch (channel) {
    case 'sway':
      return [swayAt(channels, stem, z), 0, 0];
    case 'coordinate':
      return [0, z, 0];
    case 'branch':
      return hueColour(stem * HUE_STEP);
    case 'phase':
      return hueColour(channels.phase[stem]!);
    case 'pivot': {
      const part = (k: number): number => {
        const size = bounds[3 + k]! - bounds[k]!;
        return size > 0 ? Math.min(Math.max((channels.pivot[3 * stem + k]! - bounds[k]!) / size, 0), 1) : 0;
      };
      return [part(0), part(1), part(2)];
    }
  }
}

/** Vertices of which channels are asked: those of a BarkMesh, or of leaves by `leafSurface`. */
export interface ChannelSurface {
  readonly vertexCount: number;
  /** The piece that each vertex is on, and the part of its whole stem, 0..1. */
  readonly piece: ArrayLike<number>;
  readonly v: ArrayLike<number>;
  /** Where the vertices are of leaves: phase in turns, way along the blade (0 stalk, 1 tip), and foot of the stalk (3 a vertex, tree space). */
  readonly leaf?: {
    readonly phase: ArrayLike<number>;
    readonly along: ArrayLike<number>;
    readonly foot: ArrayLike<number>;
  };
}

/** The vertices of expanded leaves: each has the stem on which its leaf hangs, and the place of the stalk there. */
export function leafSurface(leaves: LeafPlacements, triangles: LeafTriangles, { pieces }: GrownPacked): ChannelSurface {
  const { vertexCount, leaf, uv } = triangles;
  const piece = new Uint32Array(vertexCount);
  const v = new Float32Array(vertexCount);
  const phase = new Float32Array(vertexCount);
  const along = new Float32Array(vertexCount);
  const foot = new Float32Array(3 * vertexCount);
  for (let i = 0; i < vertexCount; i++) {
    const at = leaf[i]!;
    const p = leaves.piece[at]!;
    piece[i] = p;
    v[i] = pieces.span[2 * p]! * (1 - leaves.u[at]!) + pieces.span[2 * p + 1]! * leaves.u[at]!;
    phase[i] = leaves.phase[at]!;
    along[i] = uv[2 * i + 1]!;
    for (let k = 0; k < 3; k++) foot[3 * i + k] = leaves.position[3 * at + k]!;
  }
  return { vertexCount, piece, v, leaf: { phase, along, foot } };
}

/**
 * The attributes of our own, as floats: `_WT_BRANCH` index of the stem, `_WT_S` part of the stem from base to tip, `_WT_PHASE` turns,
 * `_WT_PIVOT` base of the stem, in metres, y up. A leaf has the stem on which it hangs, its own phase, and the foot of its stalk.
 */
export function windAttributes(surface: ChannelSurface, grown: GrownPacked): GlbAttribute[] {
  const channels = stemChannels(grown.stems, grown.tree.species.wind.stiffness);
  const { vertexCount, piece, v, leaf } = surface;
  const branch = new Float32Array(vertexCount);
  const s = new Float32Array(vertexCount);
  const phase = new Float32Array(vertexCount);
  const pivot = new Float32Array(3 * vertexCount);
  for (let i = 0; i < vertexCount; i++) {
    const stem = grown.pieces.stem[piece[i]!]!;
    branch[i] = stem;
    s[i] = v[i]!;
    phase[i] = leaf ? leaf.phase[i]! : channels.phase[stem]!;
    const [from, at] = leaf ? [leaf.foot, i] : [channels.pivot, stem];
    pivot[3 * i] = from[3 * at]!;
    pivot[3 * i + 1] = from[3 * at + 2]!;
    pivot[3 * i + 2] = -from[3 * at + 1]!;
  }
  return [
    { semantic: '_WT_BRANCH', size: 1, array: branch },
    { semantic: '_WT_S', size: 1, array: s },
    { semantic: '_WT_PHASE', size: 1, array: phase },
    { semantic: '_WT_PIVOT', size: 3, array: pivot },
  ];
}

/**
 * Colours as Godot's page "Making trees" reads them: red how much a place sways; green the way along the stem, or along a leaf's blade;
 * blue the phase; alpha 1. Bytes, linear.
 */
export function godotColours(surface: ChannelSurface, grown: GrownPacked): GlbAttribute {
  const channels = stemChannels(grown.stems, grown.tree.species.wind.stiffness);
  const { vertexCount, piece, v, leaf } = surface;
  const array = new Uint8Array(4 * vertexCount);
  for (let i = 0; i < vertexCount; i++) {
    const stem = grown.pieces.stem[piece[i]!]!;
    array[4 * i] = Math.round(255 * Math.min(1, swayAt(channels, stem, v[i]!)));
    array[4 * i + 1] = Math.round(255 * (leaf ? leaf.along[i]! : v[i]!));
    array[4 * i + 2] = Math.round(255 * (leaf ? leaf.phase[i]! : channels.phase[stem]!));
    array[4 * i + 3] = 255;
  }
  return { semantic: 'COLOR_0', size: 4, array, normalized: true };
}
