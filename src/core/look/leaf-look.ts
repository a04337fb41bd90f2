import type { FoliageLook } from '../species/species.ts';
import type { LeafForm } from './blade.ts';
import { byte, type Colour, colourOf, mixColours, toSrgb } from './colour.ts';
import { veinsAt } from './leaf-veins.ts';

const fraction = (x: number): number => x - Math.floor(x);

const times = ([r, g, b]: Colour, f: number): Colour => [r * f, g * f, b * f];

/** How far a leaf of a number 0..1 has turned to the second colour, 0..1. As shaders/leaf/ramp.glsl has it. */
export function leafTurn({ second, secondShare }: FoliageLook, own: number): number {
  if (!second) return 0;
  const t = Math.min(1, Math.max(0, (1.45 * secondShare - fraction(own * 23.93)) / 0.45));
  return t * t * (3 - 2 * t);
}

/** The upper face of a leaf that has turned so far: by way of what shines through it. */
export function leafRamp(foliage: FoliageLook, turned: number): Colour {
  const colour = colourOf(foliage.colour);
  const second = foliage.second ? colourOf(foliage.second) : colour;
  const between = mixColours(mixColours(colour, second, 0.5), colourOf(foliage.glow), 0.4);
  return turned < 0.5 ? mixColours(colour, between, 2 * turned) : mixColours(between, second, 2 * turned - 1);
}

/** Colour of a leaf by its own number, 0..1, as shaders/leaf/look-vertex.glsl has it, between upper and lower face. */
export function leafColour(foliage: FoliageLook, own: number): Colour {
  const turned = leafTurn(foliage, own);
  const value = 1 + foliage.variation * (fraction(own * 7.31) - 0.5) * 1.1;
  const young = foliage.variation * fraction(own * 13.7) * (1 - turned);
  const warm = foliage.variation * (fraction(own * 31.7) - 0.5);
  const upper = mixColours(leafRamp(foliage, turned), colourOf(foliage.glow), young * 0.8);
  const [r, g, b] = mixColours(upper, colourOf(foliage.under), 0.12 * (1 - 0.6 * turned));
  return [r * value * (1 + 0.35 * warm), g * value, b * value * (1 - 0.35 * warm)];
}

/** How much lighter than the blade its midrib is. */
const RIB = 1.35;

/** The largest value of each part that `leafColour` takes times the lightness of the midrib, at most 1: a material's colour. */
export function brightestLeaf(foliage: FoliageLook): Colour {
  const colours = [0, 0.5, 1].map((turned) =>
    leafRamp(foliage, foliage.second && foliage.secondShare > 0 ? turned : 0),
  );
  const all = [...colours, ...colours.map((c) => mixColours(c, colourOf(foliage.under), 0.12))].flatMap((c) => [
    c,
    mixColours(c, colourOf(foliage.glow), 0.8 * foliage.variation),
  ]);
  const most = (1 + 0.55 * foliage.variation) * (1 + 0.18 * foliage.variation);
  const part = (k: 0 | 1 | 2): number => Math.min(1, most * Math.max(...all.map((c) => c[k])));
  return [part(0), part(1), part(2)];
}

/** Light that a blade lets through, 1 for one of common thickness. */
export const leafThin = ({ thickness }: FoliageLook): number => (1 - thickness) / 0.7;

/** Colour of the light that the leaves let through, on the average of a tree. */
export function throughColour(foliage: FoliageLook): Colour {
  const share = foliage.second ? foliage.secondShare : 0;
  const second = foliage.second ? colourOf(foliage.second) : colourOf(foliage.colour);
  const glow = mixColours(colourOf(foliage.glow), times(second, 1.3), share);
  const [r, g, b] = mixColours(glow, times(leafRamp(foliage, share), 1.6), 0.4);
  return [Math.min(1, r), Math.min(1, g), Math.min(1, b)];
}

/**
 * Veins of a leaf as an sRGB image of three bytes a texel, first row at the tip: how light the blade is against its midrib, which is white.
 * `strength` as foliage.veins has it.
 */
export function leafImage(size: number, form: LeafForm, strength: number): Uint8Array {
  const out = new Uint8Array(3 * size * size);
  const shown = Math.min(1, 2 * strength);
  for (let row = 0; row < size; row++) {
    const z = 1 - (row + 0.5) / size;
    for (let x = 0; x < size; x++) {
      const across = Math.abs(2 * ((x + 0.5) / size) - 1);
      const { rib, side, rise } = veinsAt(form, across, z);
      const blade = 1 - shown * (0.12 * side - 0.1 * (rise - 0.5));
      const value = blade * (1 + (RIB - 1) * shown * Math.max(rib, 0.4 * side));
      out.fill(byte(toSrgb(Math.min(1, value / RIB))), 3 * (row * size + x), 3 * (row * size + x) + 3);
    }
  }
  return out;
}

/** What a material's colour is multiplied by where its image is that of `leafImage`, so that blades keep their colour. */
export const LEAF_IMAGE_GAIN = RIB;
