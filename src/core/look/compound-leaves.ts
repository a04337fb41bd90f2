import { type Blade, coveringAs, flatBlade, LEAF_BEND, type LeafForm } from './blade.ts';
import { LEAFLET, LEAFLET_OF_THREE, NEEDLE, OBOVATE, SPIKE } from './blade-outlines.ts';
import type { HalfOutline, LeafGrain } from './leaf-outline.ts';

/** Base, turn in degrees and size of each of three leaflets. */
const THREE = [
  [0.38, 0, 0.62],
  [0.3, 68, 0.52],
  [0.3, -68, 0.52],
] as const;

/** Three leaflets, each as much wider than long as the species says. */
export const TRIFOLIATE: LeafForm = {
  name: 'three leaflets',
  veins: 'pinnate',
  stalk: 0.36,
  blades: (width, grain) =>
    THREE.map(([z, turn, size]) =>
      flatBlade(LEAFLET_OF_THREE[grain], [width * size, size], [0, z], turn, grain === 'near' ? 2 : 0),
    ),
};

/** Leaflets droop a little from their rachis. */
const DROOP = { ...LEAF_BEND, curl: 0.22 };

const rachis = (): Blade => flatBlade(NEEDLE.far, [0.02, 0.86], [0, 0], 0, 0, { ...LEAF_BEND, fold: 0, arch: 0 });

/** A pair of leaflets as one triangle that opens forward. */
const PAIR: HalfOutline = [
  [0, 0],
  [0.5, 1],
];

/** How the leaflets of a feather stand. */
interface FeatherPlan {
  readonly pairs: number;
  /** Where the lowest pair stands, and how far apart two pairs do. */
  readonly from: number;
  readonly pitch: number;
  /** Turn of the lowest pair in degrees, and how much more the highest leans forward. */
  readonly turn: number;
  readonly lean: number;
  /** Width of a leaflet in its lengths, at most. */
  readonly broad: number;
  /** Length of the leaflet at the end at most. */
  readonly last: number;
}

const ASH: FeatherPlan = { pairs: 6, from: 0.1, pitch: 0.8 / 6, turn: 72, lean: 22, broad: 0.5, last: 0.3 };
const ROSE: FeatherPlan = { pairs: 3, from: 0.14, pitch: 0.22, turn: 66, lean: 14, broad: 0.5, last: 0.4 };

/** From some way off: pairs that are one triangle each. */
function chevrons(width: number, pairs: number): Blade[] {
  const pitch = 0.8 / pairs;
  return Array.from({ length: pairs }, (_, i) =>
    flatBlade(PAIR, [width * (1 - 0.08 * i), 1.25 * pitch], [0, 0.08 + pitch * i], 0, 0, { ...LEAF_BEND, curl: 0 }),
  );
}

/** The leaflet at the end, beyond chevrons. */
const endLeaflet = (width: number): Blade => flatBlade(SPIKE, [0.32 * width, 0.26], [0, 0.78], 0, 0);

function feather(width: number, { pairs, from, pitch, turn, lean, broad, last }: FeatherPlan): Blade[] {
  const out: Blade[] = [rachis()];
  const leaflet = LEAFLET.near;
  const ribs = 1;
  for (let i = 0; i < pairs; i++) {
    const z = from + pitch * i;
    // The longest stand below the middle; all lean forward.
    const length = ((0.5 * width) / 0.92) * (0.86 + 0.14 * Math.sin(Math.PI * Math.min(1, 0.25 + i / pairs)));
    const size = [Math.min(broad * length, 1.2 * pitch), length] as const;
    for (const side of [-1, 1])
      out.push(flatBlade(leaflet, size, [0, z], side * (turn - lean * (i / pairs)), ribs, DROOP));
  }
  const end = Math.min(last, 0.55 * width);
  out.push(flatBlade(leaflet, [Math.max(0.42, broad) * end, end], [0, 1 - end], 0, ribs, DROOP));
  return out;
}

const featherForm = (name: string, plan: FeatherPlan): LeafForm => ({
  name,
  veins: 'pinnate',
  blades: (width, grain) => {
    const near = feather(width, plan);
    if (grain === 'near') return near;
    const coarse =
      grain === 'middle' ? [...chevrons(width, Math.min(4, plan.pairs)), endLeaflet(width)] : chevrons(width, 2);
    return coveringAs(near, coarse);
  },
});

/** A feather of 13 leaflets on a rachis: ash, walnut, rowan, a frond of fern. `width`: of the whole feather. */
export const FEATHER = featherForm('feather of leaflets', ASH);

/** Seven broad leaflets on a rachis: roses, elder, bladdernut. `width`: of the whole leaf. */
export const SEVEN_LEAFLETS = featherForm('seven leaflets', ROSE);

/** Turn in degrees and size of the leaflets of a hand. */
const FINGERS = [
  [0, 1],
  [36, 0.96],
  [-36, 0.96],
  [74, 0.8],
  [-74, 0.8],
  [118, 0.56],
  [-118, 0.56],
] as const;

function hand(width: number, grain: LeafGrain): Blade[] {
  const fingers = grain === 'near' ? FINGERS : FINGERS.slice(0, grain === 'middle' ? 5 : 3);
  const spread = grain === 'far' ? 1.7 : 1;
  return fingers.map(([turn, size]) => {
    const angle = (spread * turn * Math.PI) / 180;
    // Of the whole hand, 1.2 wide as it stands, the species says the width: fingers reach as far across as that asks.
    const reach = size * 0.72 * (1 + (width / 1.2 - 1) * Math.abs(Math.sin(angle)));
    return flatBlade(OBOVATE[grain], [0.36 * reach, reach], [0, 0.28], spread * turn, grain === 'near' ? 1 : 0, DROOP);
  });
}

/** A hand of seven leaflets: horse chestnut, buckeye. `width`: of the whole hand. */
export const HAND: LeafForm = {
  name: 'hand of leaflets',
  veins: 'pinnate',
  stalk: 0.3,
  blades: (width, grain) =>
    grain === 'near' ? hand(width, grain) : coveringAs(hand(width, 'near'), hand(width, grain)),
};

/** Leaves of several blades, by `leaves.shape`. */
export const COMPOUND_FORMS: Readonly<Record<number, LeafForm>> = {
  5: TRIFOLIATE,
  9: FEATHER,
  10: HAND,
  20: SEVEN_LEAFLETS,
};
