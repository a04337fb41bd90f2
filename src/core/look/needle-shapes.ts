import { axisBlade, type Blade, bladeArea, coveringAs, FLAT, flatBlade, type LeafForm, type Vector } from './blade.ts';
import { NEEDLE, SPIKE } from './blade-outlines.ts';
import type { LeafGrain } from './leaf-outline.ts';
import { type Tooth, teethOf, toothArea } from './tooth.ts';

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
const NEEDLE_WIDTH = { rosette: 0.075, bundle: 0.024, sprig: 0.09 } as const;

/** Needles that a coarser grain draws. */
const pick = (grain: LeafGrain, near: number, middle: number, far: number): number =>
  grain === 'near' ? near : grain === 'middle' ? middle : far;

/** Width of a needle on a shoot at most, in lengths of the shoot. */
const THICKEST = 0.0315;

/** One needle; `width` is its own. */
export const SINGLE_NEEDLE = covering('needle', (width, grain) => [
  flatBlade(NEEDLE[grain], [width, 1], [0, 0], 0, 0, { fold: 0.3, arch: 0, curl: 0.06 }),
]);

/** A needle by its length, its tilt from the shoot and its place around it, degrees. */
type Needle = readonly [length: number, tilt: number, around: number];

/** Where the tip of a needle is whose foot is at height z. */
function tipOf([length, tilt, around]: Needle, z: number): Vector {
  const [t, a] = [(tilt * Math.PI) / 180, (around * Math.PI) / 180];
  const away = length * Math.sin(t);
  return [away * Math.cos(a), away * Math.sin(a), z + length * Math.cos(t)];
}

/** Needles that leave one place, so broad there that they cover `area`, unless they are too close to one another for that. */
function tuft(area: number, tips: readonly Vector[]): Tooth[] {
  const thin = tips.map((tip): Tooth => ({ foot: [0, 1], tip }));
  const broad = Math.min(1, area / toothArea(thin));
  return thin.map(({ tip }) => ({ foot: [0, broad], tip }));
}

/** Needles of a rosette, even on the part of a sphere from near the axis to a little below a right angle. */
const radiating = (count: number): Needle[] =>
  Array.from({ length: count }, (_, i) => {
    const tilt = (Math.acos(0.93 - 1.08 * ((i + 0.5) / count)) * 180) / Math.PI;
    return [0.86 + 0.14 * Math.sin(2.4 * i), tilt, GOLDEN * i];
  });

const rosette = (width: number): Blade[] =>
  radiating(21).map(([length, tilt, around]) =>
    stretched(
      axisBlade(NEEDLE.middle, [NEEDLE_WIDTH.rosette, length], 0, tilt, around, { ...FLAT, curl: 0.08 }),
      width,
    ),
  );

/** About 20 needles that radiate from a short shoot: larch, cedar. Its length is the needles'; `width` 1 is round. */
export const ROSETTE: LeafForm = {
  name: 'rosette of needles',
  veins: 'none',
  blades: (width, grain) => (grain === 'near' ? rosette(width) : []),
  teeth: (width, grain) => {
    if (grain === 'near') return null;
    const tips = radiating(pick(grain, 0, 13, 6)).map((needle) => tipOf(needle, 0));
    return teethOf(
      tuft(
        bladeArea(rosette(width)),
        tips.map(([x, y, z]): Vector => [width * x, width * y, z]),
      ),
    );
  },
};

/** Needles of a bundle, `width` between their tips; every other one stands within the rest where there are six. */
function bundled(width: number, count: number): Needle[] {
  const spread = (Math.atan(0.5 * width) * 180) / Math.PI;
  return Array.from({ length: count }, (_, i) => {
    const inner = count === 6 && i % 2 === 1;
    return [inner ? 0.94 : 1, spread * (inner ? 0.45 : 1), (360 / count) * i + 24];
  });
}

const bundleBlades = (width: number): Blade[] =>
  bundled(width, 6).map(([length, tilt, around]) =>
    axisBlade(NEEDLE.near, [NEEDLE_WIDTH.bundle, length], 0, tilt, around, { ...FLAT, curl: -0.04 }),
  );

/** Two or three long needles from one sheath, drawn as six so that few bundles make a dense shoot: pine. `width`: between their tips. */
export const BUNDLE_OF_NEEDLES: LeafForm = {
  name: 'bundle of needles',
  veins: 'none',
  blades: (width, grain) => (grain === 'near' ? bundleBlades(width) : []),
  teeth: (width, grain) =>
    grain === 'near'
      ? null
      : teethOf(
          tuft(
            bladeArea(bundleBlades(width)),
            bundled(width, pick(grain, 0, 6, 4)).map((needle) => tipOf(needle, 0)),
          ),
        ),
};

/** Needles of a sprig, near by: a triangle each, as many thin ones as can be had rather than fewer with a shape of their own. */
const SPRIG_NEEDLES = 80;

/** Length and tilt from the shoot, degrees, of the needle that stands `along` the shoot, 0..1: those near the tip lie closer to it and close it. */
function sprigNeedle(width: number, along: number): readonly [length: number, tilt: number] {
  const shape = 0.82 + 0.36 * Math.sin(Math.PI * (0.15 + 0.7 * along)) - 0.16 * along;
  return [((0.5 * width) / 0.85) * shape, 62 - 40 * along ** 3];
}

function sprig(width: number): Blade[] {
  const out: Blade[] = [axisBlade(NEEDLE.far, [0.022, 0.98], 0, 0, 0)];
  for (let i = 0; i < SPRIG_NEEDLES; i++) {
    const along = (i + 0.5) / SPRIG_NEEDLES;
    const [length, tilt] = sprigNeedle(width, along);
    const size = [Math.min(NEEDLE_WIDTH.sprig * length, THICKEST), length] as const;
    out.push(axisBlade(SPIKE, size, 0.9 * along, tilt, GOLDEN * i, { ...FLAT, curl: 0.1 }));
  }
  return out;
}

/** Part of the area of a sprig's needles that is not hidden by others of it. */
const SEEN = 0.85;

/** How far a tooth leans along the shoot, by how far it reaches out from it: one that stood upright on its broad foot would read as a leaf. */
const LEAN = 1.9;
/** And how far its tip is from the foot of the shoot at most. */
const FARTHEST = 1.08;

/** Some way off: a brush of teeth, whose silhouette is a shoot's and not a leaf's. They reach as far out as covers what the needles do. */
function brush(width: number, grain: LeafGrain): Tooth[] {
  // Wide shoots need more of them to cover as much.
  const rows = width < 0.45 ? 1 : 2;
  const segments = pick(grain, 0, rows === 1 ? 8 : 5, rows === 1 ? 4 : 3);
  const teeth = Array.from({ length: rows * segments }, (_, i): Tooth => {
    const [low, high] = [Math.floor(i / rows) / segments, (Math.floor(i / rows) + 1) / segments];
    const along = (low + high) / 2;
    const tip = tipOf([...sprigNeedle(width, along), GOLDEN * i], 0.9 * along);
    return { foot: [0.9 * low, 0.9 * high], tip };
  });
  const reach = (SEEN * bladeArea(sprig(width))) / toothArea(teeth);
  return teeth.map(({ foot, tip: [x, y, z] }) => {
    const out = reach * Math.hypot(x, y);
    const leaning = (foot[0] + foot[1]) / 2 + LEAN * out;
    return {
      foot,
      tip: [reach * x, reach * y, Math.max(z, Math.min(leaning, Math.sqrt(Math.max(0, FARTHEST ** 2 - out ** 2))))],
    };
  });
}

/** A short shoot with needles all around, pointing forward: spruce, fir, pine, yew, juniper. `width`: of the whole shoot. */
export const SPRIG: LeafForm = {
  name: 'sprig of needles',
  veins: 'none',
  blades: (width, grain) => (grain === 'near' ? sprig(width) : []),
  teeth: (width, grain) => (grain === 'near' ? null : teethOf(brush(width, grain))),
};

/** A flat spray of branchlets covered with scales: cedar, cypress, arborvitae. `width`: of the whole spray. */
export const SCALES = covering('spray of scales', (width, grain) => {
  const bend = { fold: 0.1, arch: 0, curl: 0.14 };
  if (grain === 'far') return [flatBlade(NEEDLE.far, [width, 1], [0, 0], 0, 0, bend)];
  const pairs = pick(grain, 6, 4, 0);
  const stout = pick(grain, 0.058, 0.12, 0);
  // Some way off more of them that are a triangle each, and not two: few broad ones would read as the lobes of a maple's leaf.
  const finger = grain === 'near' ? NEEDLE.near : SPIKE;
  const out: Blade[] = [flatBlade(finger, [stout, 1], [0, 0], 0, 0, bend)];
  for (let i = 0; i < 2 * pairs; i++) {
    const along = (i + 0.5) / (2 * pairs);
    const side = i % 2 === 0 ? -1 : 1;
    const turn = side * (48 - 16 * along);
    // Branchlets are longest in the lower third, so that the spray is a fan with a point.
    const length = ((0.5 * width) / 0.68) * (0.55 + 0.6 * Math.sin(Math.PI * (0.22 + 0.66 * along)));
    const z = 0.06 + 0.76 * along;
    out.push(flatBlade(finger, [stout * 1.15, length], [0, z], turn, 0, bend));
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
