import { cosTurns, sinTurns } from '../math/trig.ts';
import type { ForestDocument, HillsTerrain } from './forest.ts';
import type { GreyMap } from './grey-map.ts';
import { octaveNoise } from './ground-noise.ts';
import { type HeightField, levelField } from './height-field.ts';

/** Metres between samples of hills, and how many a side has. */
const CELL = 2.5;
const SIDES = [65, 513] as const;

/** Part of the last octave's height that the next has: hills below half a halving are round, as ground that trees hold is. */
const GAIN = 0.42;

const clamp = (x: number): number => Math.min(1, Math.max(0, x));

/** Hills over `size` metres; their lowest point has the height 0. */
export function hillsField(terrain: HillsTerrain, size: number): HeightField {
  const { seed, relief, scale, octaves, rise, valley, riseTo } = terrain;
  const side = Math.min(SIDES[1], Math.max(SIDES[0], Math.ceil(size / CELL) + 1));
  const heights = new Float32Array(side * side);
  const cell = size / (side - 1);
  const ex = cosTurns(riseTo / 360);
  const ey = sinTurns(riseTo / 360);
  // A wave shorter than two samples would only be noise of the sampling.
  let seen = 1;
  while (seen < octaves && scale / 2 ** seen > 2 * cell) seen++;
  let least = Number.POSITIVE_INFINITY;
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const x = i * cell - size / 2;
      const y = j * cell - size / 2;
      const along = (ex * x + ey * y) / size;
      const up = clamp(along + 0.5);
      const aside = clamp(2 * Math.abs(along));
      const height =
        relief * 0.5 * (relief > 0 ? octaveNoise(x / scale, y / scale, seed, seen, GAIN) : 0) +
        rise * up * up * (3 - 2 * up) +
        valley * aside * aside * (3 - 2 * aside);
      heights[j * side + i] = height;
      least = Math.min(least, height);
    }
  }
  for (let k = 0; k < heights.length; k++) heights[k] = heights[k]! - least;
  return { size, side, heights };
}

/** Heights of a grey picture whose top is north: `black` and `white` metres and between. */
export function mapField(map: GreyMap, size: number, black: number, white: number): HeightField {
  const heights = Float32Array.from(map.values, (grey) => black + (white - black) * grey);
  return { size, side: map.side, heights };
}

/**
 * The ground of a forest. `map` is the picture that its terrain asks for, null where there is none at hand: then the ground is level.
 */
export function forestField(
  { terrain, size }: Pick<ForestDocument, 'terrain' | 'size'>,
  map: GreyMap | null,
): HeightField {
  if (terrain.kind === 'hills') return hillsField(terrain, size);
  return map ? mapField(map, size, terrain.black, terrain.white) : levelField(size);
}
