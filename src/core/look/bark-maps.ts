import type { BarkLook } from '../species/species.ts';
import { barkPoint } from './bark-colour.ts';
import { growthImage } from './bark-growth.ts';
import { barkImage } from './bark-image.ts';
import { smoothstep } from './bark-relief.ts';
import { barkWrap } from './bark-wrap.ts';
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

/**
 * The bark of a species as the images of a material: what shaders/branch/bark-fragment.glsl makes of one image; `size` a power of two.
 *
 * A tile is the same all over a tree. Lichen is in it; moss lies in its cracks wherever they are, not at the foot and on the shaded side
 * alone; clouds of tone, a birch's black foot and the change from old bark to young along a stem are not in it.
 */
export function barkMaps(bark: BarkLook, size: number): BarkMaps {
  const { data } = barkImage(bark.kind, size);
  const colour = new Uint8Array(3 * size * size);
  const normal = new Uint8Array(3 * size * size);
  const surface = new Uint8Array(3 * size * size);
  const points = Array.from({ length: 256 }, (_, i) => barkPoint(bark, i / 255));
  const grown = bark.moss > 0 || bark.lichen > 0 ? growth(bark, size) : null;
  for (let row = 0; row < size; row++) {
    for (let x = 0; x < size; x++) {
      // The texture runs up the stem, an image runs down the page.
      const from = 4 * ((size - 1 - row) * size + x);
      const to = 3 * (row * size + x);
      const point = points[data[from]!]!;
      const [tint, bare] = grown ? grown(from, point, data[from + 3]! / 255) : [point.colour, 1];
      for (let k = 0; k < 3; k++) colour[to + k] = byte(toSrgb(tint[k]!));
      const relief = bark.relief * bare;
      const [sx, sy] = [slope(data[from + 1]!) * relief, slope(data[from + 2]!) * relief];
      const n = 1 / Math.sqrt(sx * sx + sy * sy + 1);
      normal[to] = byte(0.5 - 0.5 * sx * n);
      normal[to + 1] = byte(0.5 - 0.5 * sy * n);
      normal[to + 2] = byte(0.5 + 0.5 * n);
      surface[to] = byte(1 - 0.45 * bark.relief * point.crack);
      surface[to + 1] = byte(bark.roughness + (1 - bark.roughness) * 0.7 * point.crack);
    }
  }
  return { size, colour, normal, surface };
}

type Point = ReturnType<typeof barkPoint>;

/** What lichen and moss make of a texel's colour and relief; `from`: four times its number. */
function growth(bark: BarkLook, size: number): (from: number, point: Point, height: number) => [Colour, number] {
  const data = growthImage(size);
  const times = Math.max(1, Math.round(barkWrap(bark).side / 0.7));
  const [lichenColour, mossColour] = [colourOf(bark.lichenColour), colourOf(bark.mossColour)];
  return (from, { colour, crack }, height) => {
    const [x, y] = [(from / 4) & (size - 1), Math.floor(from / 4 / size)];
    const g = 4 * (((y * times) & (size - 1)) * size + ((x * times) & (size - 1)));
    const fine = data[g + 2]! / 255 - 0.5;
    const crust = data[g + 1]! / 255 - (1 - 0.8 * bark.lichen) + 0.1 * fine + 0.12 * (height - 0.5);
    const lichen = bark.lichen > 0 ? 0.8 * smoothstep(-0.03, 0.11, crust) * (1 - 0.85 * crack) : 0;
    const light = 0.62 + 0.7 * fine + 0.25 * smoothstep(0.16, 0.04, crust);
    const crusted = mixColours(colour, shaded(lichenColour, light, colour, 0.25), lichen);
    const bed = 0.3 + 0.9 * (data[g + 3]! / 255 - 0.5) + 0.25 * fine + 0.2 * (crack - 0.3) - 1.25 + 1.35 * bark.moss;
    const moss = bark.moss > 0 ? 0.95 * smoothstep(-0.06, 0.16, bed) : 0;
    const tuft = 0.72 + 1.1 * fine * (1 + bed) + 0.3 * smoothstep(0, 0.4, bed);
    return [mixColours(crusted, shaded(mossColour, tuft, colour, 0), moss), 1 - 0.55 * moss];
  };
}

/** s a + t b. */
const shaded = (a: Colour, s: number, b: Colour, t: number): Colour => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
  s * a[2] + t * b[2],
];

/** A stored slope, s / (1 + |s|) in eight bits, back to s; the steepest are cut off as the shader cuts them. */
function slope(stored: number): number {
  const s = stored / 127.5 - 1;
  return s / (1.05 - Math.abs(s));
}
