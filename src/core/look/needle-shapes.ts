import { axisBlade, type Blade, coveringAs, FLAT, flatBlade, type LeafForm } from './blade.ts';
import { NEEDLE, SPIKE } from './blade-outlines.ts';
import type { LeafGrain } from './leaf-outline.ts';

/** The angle from leaf to leaf that leaves no two above each other, degrees. */
const GOLDEN = 137.508;

/** A form whose coarser grains cover as much as its finest. */
const covering = (name: string, blades: LeafForm['blades']): LeafForm => ({
  name,
  veins: 'none',
  blades: (width, grain) => {
    const near = blades(width, 'near');
    return grain === 'near' ? near : coveringAs(near, blades(width, grain));
  },
});

/** A needle is drawn a little wider than it grows: a tree has tens of thousands of them here, not millions. */
const NEEDLE_WIDTH = { rosette: 0.075, bundle: 0.024, sprig: 0.16 } as const;

/** Needles that a coarser grain draws. */
const pick = (grain: LeafGrain, near: number, middle: number, far: number): number =>
  grain === 'near' ? near : grain === 'middle' ? middle : far;

/** Width of a needle on a shoot at most, in lengths of the shoot. */
const THICKEST = 0.056;

/** One needle; `width` is its own. */
export const SINGLE_NEEDLE = covering('needle', (width, grain) => [
  flatBlade(NEEDLE[grain], [width, 1], [0, 0], 0, 0, { fold: 0.3, arch: 0, curl: 0.06 }),
]);

/** About 20 needles that radiate from a short shoot: larch, cedar. Its length is the needles'; `width` 1 is round. */
export const ROSETTE = covering('rosette of needles', (width, grain) => {
  const count = pick(grain, 21, 13, 3);
  return Array.from({ length: count }, (_, i): Blade => {
    // Even on the part of a sphere from near the axis to a little below a right angle.
    const tilt = (Math.acos(0.93 - 1.08 * ((i + 0.5) / count)) * 180) / Math.PI;
    const length = 0.86 + 0.14 * Math.sin(2.4 * i);
    const blade = axisBlade(
      grain === 'near' ? NEEDLE.middle : SPIKE,
      [NEEDLE_WIDTH.rosette, length],
      0,
      tilt,
      GOLDEN * i,
      {
        ...FLAT,
        curl: 0.08,
      },
    );
    return stretched(blade, width);
  });
});

/** Two or three long needles from one sheath, drawn as six so that few bundles make a dense shoot: pine. `width`: between their tips. */
export const BUNDLE_OF_NEEDLES = covering('bundle of needles', (width, grain) => {
  const count = pick(grain, 6, 3, 2);
  const spread = (Math.atan(0.5 * width) * 180) / Math.PI;
  return Array.from({ length: count }, (_, i): Blade => {
    const inner = count > 3 && i % 2 === 1;
    return axisBlade(
      NEEDLE[grain],
      [NEEDLE_WIDTH.bundle, inner ? 0.94 : 1],
      0,
      spread * (inner ? 0.45 : 1),
      (360 / count) * i + 24,
      { ...FLAT, curl: -0.04 },
    );
  });
});

/** A short shoot with needles all around, pointing forward: spruce, fir, yew, juniper. `width`: of the whole shoot. */
export const SPRIG = covering('sprig of needles', (width, grain) => {
  if (grain === 'far') {
    return [20, 110].map((around) => axisBlade(NEEDLE.far, [0.2, 1], 0, 3, around));
  }
  const count = pick(grain, 30, 8, 0);
  // Fewer needles on a wider shoot keep the shape of the whole.
  const shoot = grain === 'near' ? 0.022 : 0.045;
  const needle = grain === 'near' ? NEEDLE.middle : SPIKE;
  const out: Blade[] = [axisBlade(NEEDLE.far, [shoot, 0.98], 0, 0, 0)];
  for (let i = 0; i < count; i++) {
    const along = (i + 0.5) / count;
    // Needles near the tip lie closer to the shoot and close it.
    const tilt = 62 - 40 * along ** 3;
    const length = ((0.5 * width) / 0.85) * (0.82 + 0.36 * Math.sin(Math.PI * (0.15 + 0.7 * along)) - 0.16 * along);
    const z = 0.9 * along;
    out.push(
      axisBlade(needle, [Math.min(NEEDLE_WIDTH.sprig * length, THICKEST), length], z, tilt, GOLDEN * i, {
        ...FLAT,
        curl: 0.1,
      }),
    );
  }
  return out;
});

/** A flat spray of branchlets covered with scales: cedar, cypress, arborvitae. `width`: of the whole spray. */
export const SCALES = covering('spray of scales', (width, grain) => {
  const bend = { fold: 0.1, arch: 0, curl: 0.14 };
  if (grain === 'far') return [flatBlade(NEEDLE.far, [width, 1], [0, 0], 0, 0, bend)];
  const pairs = pick(grain, 6, 2, 0);
  const stout = pick(grain, 0.058, 0.15, 0);
  const out: Blade[] = [flatBlade(NEEDLE[grain], [stout, 1], [0, 0], 0, 0, bend)];
  for (let i = 0; i < 2 * pairs; i++) {
    const along = (i + 0.5) / (2 * pairs);
    const side = i % 2 === 0 ? -1 : 1;
    const turn = side * (48 - 16 * along);
    // Branchlets are longest in the lower third, so that the spray is a fan with a point.
    const length = ((0.5 * width) / 0.68) * (0.55 + 0.6 * Math.sin(Math.PI * (0.22 + 0.66 * along)));
    const z = 0.06 + 0.76 * along;
    out.push(flatBlade(NEEDLE[grain], [stout * 1.15, length], [0, z], turn, 0, bend));
    // Each bears one of its own on its outer side.
    if (grain === 'near' && i < 9) {
      const from = 0.42 * length;
      const angle = (turn * Math.PI) / 180;
      const at = [from * Math.sin(angle), z + from * Math.cos(angle)] as const;
      out.push(flatBlade(NEEDLE.middle, [stout, 0.5 * length], at, turn * 0.25, 0, bend));
    }
  }
  return out;
});

/** The blade with all that lies across the leaf's axis made longer by a factor. */
function stretched(blade: Blade, factor: number): Blade {
  const [x, y, z] = blade.along;
  const long = Math.hypot(factor * x, factor * y, z);
  const along = [(factor * x) / long, (factor * y) / long, z / long] as const;
  const across = Math.hypot(along[0], along[1]) || 1;
  const up = [(-along[2] * along[0]) / across, (-along[2] * along[1]) / across, across] as const;
  return { ...blade, along, up, length: blade.length * long };
}

/** Needles and scales, by `leaves.shape`. */
export const NEEDLE_FORMS: Readonly<Record<number, LeafForm>> = {
  11: SINGLE_NEEDLE,
  12: ROSETTE,
  13: BUNDLE_OF_NEEDLES,
  14: SPRIG,
  15: SCALES,
};
