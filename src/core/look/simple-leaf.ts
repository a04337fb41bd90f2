import { type BladeBend, flatBlade, type LeafForm, type VeinGroup } from './blade.ts';
import type { BladeOutline } from './leaf-outline.ts';

/** Points on the midrib of a blade by grain. */
type Ribs = readonly [near: number, middle: number, far: number];
const FEW: Ribs = [3, 0, 0];

/** A leaf of one blade. */
export const simple = (
  outline: BladeOutline,
  veins: VeinGroup,
  more: { bend?: BladeBend; ribs?: Ribs; lobes?: LeafForm['lobes'] } = {},
): LeafForm => ({
  name: outline.name,
  veins,
  ...(more.lobes ? { lobes: more.lobes } : {}),
  blades: (width, grain) => {
    const ribs = (more.ribs ?? FEW)[grain === 'near' ? 0 : grain === 'middle' ? 1 : 2];
    return [flatBlade(outline[grain], [width, 1], [0, 0], 0, ribs, more.bend)];
  },
});
