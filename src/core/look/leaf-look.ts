import type { FoliageLook } from '../species/species.ts';
import { byte, type Colour, colourOf, mixColours, toSrgb } from './colour.ts';

const fraction = (x: number): number => x - Math.floor(x);

/** Colour of a leaf by its own number, 0..1, as shaders/leaf/fragment.glsl has it, between upper and lower face. */
export function leafColour(foliage: FoliageLook, own: number): Colour {
  const value = 1 + foliage.variation * (fraction(own * 7.31) - 0.5) * 1.1;
  const young = foliage.variation * fraction(own * 13.7);
  const face = mixColours(colourOf(foliage.colour), colourOf(foliage.under), 0.12);
  const [r, g, b] = mixColours(face, colourOf(foliage.glow), young * 0.8);
  return [r * value, g * value, b * value];
}

/** How much lighter than the blade its midrib is. */
const RIB = 1.35;

/** The largest value of each part that `leafColour` takes times the lightness of the midrib, at most 1: a material's colour. */
export function brightestLeaf(foliage: FoliageLook): Colour {
  const face = mixColours(colourOf(foliage.colour), colourOf(foliage.under), 0.12);
  const young = mixColours(face, colourOf(foliage.glow), 0.8 * foliage.variation);
  const most = 1 + 0.55 * foliage.variation;
  const part = (k: 0 | 1 | 2): number => Math.min(1, most * Math.max(face[k], young[k]));
  return [part(0), part(1), part(2)];
}

/** Colour of the light that a leaf lets through. */
export function throughColour(foliage: FoliageLook): Colour {
  const [r, g, b] = colourOf(foliage.colour);
  const through = mixColours(colourOf(foliage.glow), [r * 1.6, g * 1.6, b * 1.6], 0.4);
  return [Math.min(1, through[0]), Math.min(1, through[1]), Math.min(1, through[2])];
}

const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

/** Veins of a leaf as an sRGB image of three bytes a texel, first row at the tip: how light the blade is against its midrib, which is white. */
export function leafImage(size: number): Uint8Array {
  const out = new Uint8Array(3 * size * size);
  for (let row = 0; row < size; row++) {
    const z = 1 - (row + 0.5) / size;
    for (let x = 0; x < size; x++) {
      const side = Math.abs(2 * ((x + 0.5) / size) - 1);
      const rib = 1 - smoothstep(0, 0.07, side);
      const beside = Math.abs(fraction((z - 0.55 * side) * 7) - 0.5);
      const vein = 0.5 * (1 - smoothstep(0, 0.09, beside)) * (1 - smoothstep(0.3, 1, side));
      const value = (1 - 0.1 * vein) * (1 + (RIB - 1) * Math.max(rib, 0.35 * vein));
      out.fill(byte(toSrgb(Math.min(1, value / RIB))), 3 * (row * size + x), 3 * (row * size + x) + 3);
    }
  }
  return out;
}

/** What a material's colour is multiplied by where its image is that of `leafImage`, so that blades keep their colour. */
export const LEAF_IMAGE_GAIN = RIB;
