import { stemFrequencies } from '../../core/pack/mechanics.ts';
import { swayRate } from '../../core/wind/sway.ts';
import { smallTree } from '../ping-pong/small-tree.ts';

/** Natural frequency in hertz of one bare stem as our trees have it: the code of a whole tree, of a single stem. */
export function bareFrequency(length: number, radius: number): number {
  const { tree } = smallTree();
  const [omega = 0] = stemFrequencies({
    ...tree,
    stems: {
      ...tree.stems,
      count: 1,
      length: tree.stems.length.slice(0, 1).fill(length),
      baseRadius: tree.stems.baseRadius.slice(0, 1).fill(radius),
    },
    leaves: { ...tree.leaves, count: 0 },
  });
  return omega / (2 * Math.PI);
}

/** Of an elastic rod alone, hertz: 1.5 sqrt(E/density) radius/length^2 over 2 pi. Source: equations.md 6.8. */
export function rodFrequency(length: number, radius: number): number {
  const { modulus, density } = smallTree().tree.species.wind;
  return (1.5 * Math.sqrt((modulus * 1e9) / density) * radius) / (length * length * 2 * Math.PI);
}

/** Of the sway as printed, hertz: (radius/length)/15 radians a second. Source: Weber & Penn 1995, 4.7 (erratum E56). */
export const printedFrequency = (length: number, radius: number): number =>
  swayRate({ reading: 'ratio', rate: 1 / 15 }, radius, length) / (2 * Math.PI);
