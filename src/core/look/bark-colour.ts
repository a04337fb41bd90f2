import type { BarkLook } from '../species/species.ts';
import { smoothstep } from './bark-relief.ts';
import { type Colour, colourOf, mixColours } from './colour.ts';

/** Wool and spines of a cactus, and the wax that dusts a cane; linear. As in shaders/branch/bark-own.glsl. */
const STRAW: Colour = [0.6, 0.52, 0.34];
const WAX: Colour = [0.6, 0.64, 0.55];

/** What a texel's darkness, 0..1, stands for: the colour of the bark, linear, and how deep in a crack the point is, 0..1. */
export function barkPoint({ kind, colour, dark }: BarkLook, darkness: number): { colour: Colour; crack: number } {
  const [light, deep] = [colourOf(colour), colourOf(dark)];
  const plain = mixColours(light, deep, darkness);
  if (kind === 'noded') {
    return { colour: mixColours(plain, WAX, 0.4 * smoothstep(0.32, 0.04, darkness)), crack: darkness };
  }
  if (kind !== 'ribbed') return { colour: plain, crack: darkness };
  // Above a half it stands for wool and spines.
  const spine = smoothstep(0.45, 0.75, darkness);
  const crack = Math.min(1, 2 * darkness * (1 - spine));
  return { colour: mixColours(mixColours(light, deep, crack), STRAW, spine), crack };
}

/** Colour of twigs, which are younger: no furrows yet, and a skin of their own or a darker one; linear. */
export const twigColour = ({ colour, dark, young }: BarkLook): Colour =>
  young ? colourOf(young) : mixColours(colourOf(colour), colourOf(dark), 0.55);
