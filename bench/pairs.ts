import type { Season } from '../src/core/species/season.ts';

/** Each preset of ez-tree, and the species and seed of ours that stands beside it. */
export interface Pair {
  readonly preset: string;
  readonly species: string;
  readonly seed: number;
  readonly season: Season;
}

const pair = (preset: string, species: string, seed: number, season: Season = 'summer'): Pair => ({
  preset,
  species,
  seed,
  season,
});

export const PAIRS: readonly Pair[] = [
  pair('Ash Small', 'common-ash', 1),
  pair('Ash Medium', 'common-ash', 2),
  pair('Ash Large', 'common-ash', 3),
  pair('Aspen Small', 'quaking-aspen', 1, 'autumn'),
  pair('Aspen Medium', 'quaking-aspen', 2, 'autumn'),
  pair('Aspen Large', 'quaking-aspen', 3, 'autumn'),
  pair('Bush 1', 'hazel-shrub', 1),
  pair('Bush 2', 'dog-rose', 2),
  pair('Bush 3', 'hazel-shrub', 3),
  pair('Oak Small', 'young-oak', 1),
  pair('Oak Medium', 'swamp-white-oak', 2),
  pair('Oak Large', 'california-black-oak', 1),
  pair('Pine Small', 'jack-pine', 1),
  pair('Pine Medium', 'austrian-pine', 1),
  pair('Pine Large', 'scots-pine', 1),
  // A climber on a trellis has no counterpart among ours: the wild form of what people train on one stands beside it.
  pair('Trellis', 'dog-rose', 1),
];
