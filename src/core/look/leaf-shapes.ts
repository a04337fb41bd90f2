import type { Species } from '../species/species.ts';
import { type BladeBend, flatBlade, LEAF_BEND, type LeafForm, type VeinGroup } from './blade.ts';
import { GRASS, HEART, LANCE, MITTEN, SEVEN_LOBES, STRAP, TOOTHED } from './blade-outlines.ts';
import { FEATHER, HAND, TRIFOLIATE } from './compound-leaves.ts';
import type { BladeOutline } from './leaf-outline.ts';
import { marginOutline } from './margin-outline.ts';
import { BUNDLE_OF_NEEDLES, ROSETTE, SCALES, SINGLE_NEEDLE, SPRIG } from './needle-shapes.ts';
import { PAPER_OUTLINES } from './paper-outlines.ts';

/** Points on the midrib of a blade by grain. */
type Ribs = readonly [near: number, middle: number, far: number];
const FEW: Ribs = [3, 0, 0];
const LONG: Ribs = [5, 2, 1];

/** A leaf of one blade. */
const simple = (
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

const [OVAL, TRIANGLE, OAK, MAPLE_3, MAPLE_5] = PAPER_OUTLINES as [
  BladeOutline,
  BladeOutline,
  BladeOutline,
  BladeOutline,
  BladeOutline,
];

/** Index is `leaves.shape` of a species, as LEAF_SHAPES of the parameter table names them. Lengths are of the whole: blade, feather, shoot or spray. */
export const LEAF_FORMS: readonly LeafForm[] = [
  simple(OVAL, 'pinnate'),
  simple(TRIANGLE, 'pinnate'),
  simple(OAK, 'pinnate'),
  simple(MAPLE_3, 'palmate', { lobes: [[0.5, 0.62]] }),
  simple(MAPLE_5, 'palmate', {
    lobes: [
      [0.5, 0.58],
      [0.38, 0.02],
    ],
  }),
  TRIFOLIATE,
  simple(LANCE, 'pinnate', { ribs: [3, 1, 0], bend: { fold: 0.4, arch: 0.3, curl: 0.22 } }),
  simple(HEART, 'palmate', { lobes: [[0.47, 0.5]] }),
  simple(SEVEN_LOBES, 'palmate', {
    lobes: [
      [0.43, 0.64],
      [0.5, 0.22],
      [0.28, -0.07],
    ],
  }),
  FEATHER,
  HAND,
  SINGLE_NEEDLE,
  ROSETTE,
  BUNDLE_OF_NEEDLES,
  SPRIG,
  SCALES,
  simple(STRAP, 'parallel', { ribs: LONG, bend: { fold: 0.7, arch: 0, curl: 0.34 } }),
  simple(GRASS, 'parallel', { ribs: LONG, bend: { fold: 0.5, arch: 0, curl: 0.38 } }),
  simple(MITTEN, 'palmate', { lobes: [[0.48, 0.68]] }),
  simple(TOOTHED, 'pinnate'),
];

/** What a species' leaves are made from. */
export interface LeafSpec {
  /** 0 to 19. */
  readonly shape: number;
  /** Half widths of a free outline, which then takes the place of the shape. */
  readonly margin?: readonly number[] | undefined;
  /** Width and stalk in lengths of the whole: > 0 and >= 0. */
  readonly width: number;
  readonly petiole: number;
}

/** What the leaves of a species are made from. */
export const leafSpecOf = ({ foliage, leaves }: Pick<Species, 'foliage' | 'leaves'>): LeafSpec => ({
  shape: foliage.outline ?? leaves.shape,
  margin: foliage.margin,
  width: leaves.scaleX,
  petiole: leaves.petiole,
});

/** The form of a leaf; LEAF_BEND bends a free outline. Throws RangeError for an unknown shape. */
export function leafForm({ shape, margin }: Pick<LeafSpec, 'shape' | 'margin'>): LeafForm {
  if (margin && margin.length > 1) return simple(marginOutline(margin), 'pinnate', { bend: LEAF_BEND });
  const form = LEAF_FORMS[shape];
  if (!form) throw new RangeError(`leaf shape must be 0 to ${LEAF_FORMS.length - 1}, found ${shape}`);
  return form;
}
