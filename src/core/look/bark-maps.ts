import type { BarkLook } from '../species/species.ts';
import { barkImage } from './bark-image.ts';
import { byte, type Colour, colourOf, mixColours, toSrgb } from './colour.ts';

/** Square images of three bytes a texel, first row at the top, that tile. */
export interface BarkMaps {
  readonly size: number;
  /** sRGB. */
  readonly colour: Uint8Array;
  /** Tangent space, y up: along the stem where the first row is its far end. */
  readonly normal: Uint8Array;
  /** Light of the sky that reaches the point | roughness | 0, as glTF's occlusion and metallic-roughness. */
  readonly surface: Uint8Array;
}

/** The bark of a species as the images of a material: what shaders/branch/bark-fragment.glsl makes of one image; `size` a power of two. */
export function barkMaps(bark: BarkLook, size: number): BarkMaps {
  const { data } = barkImage(bark.kind, size);
  const colour = new Uint8Array(3 * size * size);
  const normal = new Uint8Array(3 * size * size);
  const surface = new Uint8Array(3 * size * size);
  const [light, dark] = [colourOf(bark.colour), colourOf(bark.dark)];
  const tints = Array.from({ length: 256 }, (_, i) => mixColours(light, dark, i / 255).map((c) => byte(toSrgb(c))));
  for (let row = 0; row < size; row++) {
    for (let x = 0; x < size; x++) {
      // The texture runs up the stem, an image runs down the page.
      const from = 4 * ((size - 1 - row) * size + x);
      const to = 3 * (row * size + x);
      const depth = data[from]!;
      colour.set(tints[depth]!, to);
      const [sx, sy] = [slope(data[from + 1]!) * bark.relief, slope(data[from + 2]!) * bark.relief];
      const n = 1 / Math.sqrt(sx * sx + sy * sy + 1);
      normal[to] = byte(0.5 - 0.5 * sx * n);
      normal[to + 1] = byte(0.5 - 0.5 * sy * n);
      normal[to + 2] = byte(0.5 + 0.5 * n);
      surface[to] = byte(1 - (0.45 * bark.relief * depth) / 255);
      surface[to + 1] = byte(bark.roughness + ((1 - bark.roughness) * 0.7 * depth) / 255);
    }
  }
  return { size, colour, normal, surface };
}

/** A stored slope, s / (1 + |s|) in eight bits, back to s; the steepest are cut off as the shader cuts them. */
function slope(stored: number): number {
  const s = stored / 127.5 - 1;
  return s / (1.05 - Math.abs(s));
}

/** Colour of twigs, which are younger: no furrows yet, and darker skin. */
export const twigColour = (bark: BarkLook): Colour => mixColours(colourOf(bark.colour), colourOf(bark.dark), 0.55);
