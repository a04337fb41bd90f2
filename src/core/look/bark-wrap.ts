import type { Shape } from '../deform/radius.ts';
import type { BarkLook } from '../species/species.ts';
import { RIBS_PER_TILE } from './bark-ribbed.ts';
import { GRAINS_PER_TILE, KEEPS_STEPS } from './bark-tile.ts';

/** How the tile of a bark is laid around stems: shaders/branch/bark-wrap.glsl does the same. */
export interface BarkWrap {
  /** Side of the tile in metres. */
  readonly side: number;
  /** Its steps along the stem keep their length, whatever the stem's girth. */
  readonly steady: boolean;
  /** Ribs that a tile holds around a stem that has some, 0 where it minds none. */
  readonly ribs: number;
}

export const barkWrap = ({ kind, grain }: Pick<BarkLook, 'kind' | 'grain'>): BarkWrap => ({
  side: grain * GRAINS_PER_TILE[kind],
  steady: KEEPS_STEPS[kind],
  ribs: kind === 'ribbed' ? RIBS_PER_TILE : 0,
});

/** A stem as the bark sees it: metres, and the phase of its bark in turns. */
export interface WrappedStem {
  readonly shape: Shape;
  readonly level: number;
  readonly baseRadius: number;
  readonly length: number;
  readonly phase: number;
}

/** Tiles around a stem; whole ones, so that the pattern closes, but where a rib has a strip of its own. */
export function tilesAround(wrap: BarkWrap, { shape, baseRadius }: WrappedStem): number {
  if (wrap.ribs > 0 && shape.lobeDepth > 0) return shape.lobes / wrap.ribs;
  return Math.max(1, Math.floor((2 * Math.PI * baseRadius) / wrap.side + 0.5));
}

/** Place on the tile, in tiles, at an angle in turns and at z in 0..1 of a stem. */
export function wrapPoint(wrap: BarkWrap, stem: WrappedStem, turns: number, z: number): [u: number, v: number] {
  const around = tilesAround(wrap, stem);
  const offset = 7 * stem.phase;
  if (wrap.ribs > 0 && stem.shape.lobeDepth > 0) {
    const shift = (Math.floor(stem.phase * wrap.ribs) + 0.25) / wrap.ribs;
    return [turns * around + shift, (z * stem.length) / wrap.side + offset];
  }
  const u = turns * around + stem.phase;
  if (wrap.steady) return [u, (z * stem.length) / wrap.side + offset];
  const tile = Math.max((2 * Math.PI * stem.baseRadius) / around, 0.12 * wrap.side);
  return [u, (stem.length * (stem.level < 2 ? evenRun(stem.shape, z) : z)) / tile + offset];
}

/** z stretched where a stem is thicker than at its base and squeezed where it is thinner, as the pattern is around it. */
function evenRun({ taper, flare }: Shape, z: number): number {
  const share = Math.max(taper < 1 ? taper : 2 - taper, 0.01);
  const left = 1 - share * z;
  const run = (5 * Math.max(0.2 - left, 0) - Math.log(Math.max(left, 0.2))) / share;
  return flare > 0 ? run + 0.027143 * Math.log((1 + flare * Math.exp(-36.841361 * z)) / (1 + flare)) : run;
}
