import { combine, hashPcg, hashUnit } from '../math/hash.ts';

/**
 * Random draws without state: each is a hash of (seed, path of the stem, name of the draw), weber-penn.md row 50.
 * So a draw does not depend on any other: editing level 2 leaves levels 0 and 1 as they were.
 */

/** Room for the index of a draw (segment, child, leaf) between two names. */
const ROOM = 1 << 22;

/** The names of the draws. Appending keeps every tree as it is; changing a number changes all trees. */
export const DRAW = {
  scale: ROOM,
  zScale: 2 * ROOM,
  trunk: 3 * ROOM,
  child: 4 * ROOM,
  clone: 5 * ROOM,
  length: 6 * ROOM,
  down: 7 * ROOM,
  rotate: 8 * ROOM,
  spiral: 9 * ROOM,
  place: 10 * ROOM,
  jitter: 11 * ROOM,
  curve: 12 * ROOM,
  side: 13 * ROOM,
  helix: 14 * ROOM,
  splits: 15 * ROOM,
  split: 16 * ROOM,
  spread: 17 * ROOM,
  azimuth: 18 * ROOM,
  radius: 19 * ROOM,
  leafSpiral: 20 * ROOM,
  leafPlace: 21 * ROOM,
  leafJitter: 22 * ROOM,
  leafRotate: 23 * ROOM,
  leafDown: 24 * ROOM,
  leafPhase: 25 * ROOM,
  disc: 26 * ROOM,
} as const;

/** The stream of a stem: what its draws are made from. */
export const streamOf = (path: number): number => hashPcg(path) | 0;

/** A draw in [0, 1). `name` is one of DRAW plus an index below 4 194 304. */
export const draw = (stream: number, name: number): number => hashUnit(hashPcg((stream + name) | 0));

/** A draw in [-a, a): the paper's "+- a". */
export const spread = (stream: number, name: number, a: number): number =>
  a === 0 ? 0 : a * (2 * hashUnit(hashPcg((stream + name) | 0)) - 1);

/** The path of the i-th trunk of a seed. */
export const trunkPath = (seed: number, i: number): number => combine(seed >>> 0, DRAW.trunk + i);

/** The path of the k-th child that a stem (or a clone) bears. */
export const childPath = (path: number, k: number): number => combine(path, DRAW.child + k);

/** The path of the j-th clone that leaves a stem at the end of a segment; at most 1024 leave one place. */
export const clonePath = (path: number, segment: number, j: number): number =>
  combine(path, DRAW.clone + segment * 1024 + j);
