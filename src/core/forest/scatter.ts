import { combine, hashPcg, hashUnit } from '../math/hash.ts';
import { type DensityField, densityAt } from './density.ts';
import type { ForestDocument, TreePlaces } from './forest.ts';
import { Sites, suitability } from './habitat.ts';
import { type HeightField, heightAt } from './height-field.ts';
import { PlaceGrid } from './place-grid.ts';

/** Each round throws its darts at discs of this part of the last round's radius. */
const SHRINK = 0.86;

/** Darts a round for each square of the radius: so many that what they leave is smaller than the next round's disc. */
const DARTS = 7;

/** Darts in all: a second's work. Only a forest that is to stand on a small part of wide ground is left unfinished by it. */
const MOST_DARTS = 3_000_000;

/** Darts of a round of which none may stay: then nothing may stand on this ground. */
const IN_VAIN = 200_000;

/** More rounds at the least spacing: they fill what is left. */
const LAST_ROUNDS = 3;

/** Of the radius: trees keep unlike distances, or a wood would look planted. */
const [NEAREST, FARTHEST] = [0.78, 1.3];

/** Below this density discs grow no more, and darts are dropped by chance instead: a disc must not be wider than the grid is searched. */
const THIN = 0.2;

/** Metres to the edge of the ground. */
const MARGIN = 0.5;

/**
 * Trees over the ground as blue noise, by dart throwing at discs that shrink round by round (after Cook 1986 and McCool & Fiume 1992): any
 * prefix is spread over the whole forest, and fewer trees are a prefix of more.
 *
 * Same document, same places. Fewer than `count` where there is no room at `spacing` metres; none closer than that. Density widens the
 * discs; a species stands where its habitat lets it, and where none may nothing stands.
 */
export function scatter(
  { seed, size, count, spacing, mix }: Pick<ForestDocument, 'seed' | 'size' | 'count' | 'spacing' | 'mix'>,
  field: HeightField,
  density: DensityField,
): TreePlaces {
  const places = emptyPlaces(count);
  const ranks = new Uint32Array(mix.length);
  const sites = new Sites(field, mix);
  const weights = new Float64Array(mix.length);
  const inner = size - 2 * MARGIN;
  let radius = size / 2;
  let standing = 0;
  let last = 0;
  let thrown = 0;
  for (let round = 0; standing < count && last < LAST_ROUNDS && thrown < MOST_DARTS; round++) {
    if (radius <= spacing) last++;
    const grid = new PlaceGrid(size, radius, places, standing);
    const draws = combine(seed, round);
    const darts = Math.min(MOST_DARTS - thrown, Math.ceil((DARTS * inner * inner) / (radius * radius)));
    thrown += darts;
    const before = standing;
    for (let dart = 0; dart < darts && standing < count; dart++) {
      const path = combine(draws, dart);
      const x = (hashUnit(path) - 0.5) * inner;
      const y = (hashUnit(hashPcg(path)) - 0.5) * inner;
      const loose = NEAREST + (FARTHEST - NEAREST) * hashUnit(combine(path, 1));
      // The plain disc first: most darts miss, and this asks least.
      if (grid.within(x, y, Math.max(spacing, radius * loose))) continue;
      const full = densityAt(density, x, y);
      if (full < THIN && hashUnit(combine(path, 2)) * THIN >= full) continue;
      if (full < 1 && grid.within(x, y, Math.max(spacing, (radius * loose) / Math.sqrt(Math.max(full, THIN)))))
        continue;
      const species = choose(hashUnit(combine(path, 3)), hashUnit(combine(path, 4)), x, y);
      if (species < 0) continue;
      places.x[standing] = x;
      places.y[standing] = y;
      places.z[standing] = heightAt(field, x, y);
      places.turn[standing] = hashUnit(combine(path, 5)) * 2 * Math.PI;
      places.species[standing] = species;
      places.variant[standing] = ranks[species]!++;
      grid.add(standing++);
    }
    if (standing === before && darts > IN_VAIN) break;
    radius = Math.max(spacing, radius * SHRINK);
  }
  return standing === count ? places : prefix(places, standing);

  /** The index of the species that stands at a place, -1 where none does; `chance` and `keep` in [0, 1). */
  function choose(chance: number, keep: number, x: number, y: number): number {
    const site = sites.at(x, y);
    let sum = 0;
    let best = 0;
    mix.forEach(({ share, where }, i) => {
      const suits = share > 0 ? suitability(where, site) : 0;
      best = Math.max(best, suits);
      weights[i] = share * suits;
      sum += weights[i]!;
    });
    // Where hardly anything may stand there are few trees, not all of the one that may.
    if (keep >= best) return -1;
    let left = chance * sum;
    for (let i = 0; i < weights.length; i++) {
      left -= weights[i]!;
      if (left < 0) return i;
    }
    return weights.findLastIndex((weight) => weight > 0);
  }
}

const emptyPlaces = (count: number): TreePlaces => ({
  count,
  x: new Float32Array(count),
  y: new Float32Array(count),
  z: new Float32Array(count),
  turn: new Float32Array(count),
  species: new Uint8Array(count),
  variant: new Uint32Array(count),
});

/** The first `count` trees. */
export const prefix = (places: TreePlaces, count: number): TreePlaces => ({
  count: Math.min(count, places.count),
  x: places.x.slice(0, count),
  y: places.y.slice(0, count),
  z: places.z.slice(0, count),
  turn: places.turn.slice(0, count),
  species: places.species.slice(0, count),
  variant: places.variant.slice(0, count),
});
