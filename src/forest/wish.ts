import type { ForestDocument } from '../core/forest/forest.ts';
import type { GreyMap } from '../core/forest/grey-map.ts';

/** What the trees and the ground of a forest depend on: where it is the same, they stay. */
export interface Wish {
  /** Says what grows and where. */
  readonly key: string;
  /** Says what the ground is. */
  readonly ground: string;
}

/** Numbers of the pictures: the same name may be another picture. */
const numbers = new WeakMap<GreyMap, number>();
let count = 0;

function numberOf(map: GreyMap | null): number {
  if (!map) return 0;
  if (!numbers.has(map)) numbers.set(map, ++count);
  return numbers.get(map)!;
}

/** What a document with its pictures asks for. */
export function wishOf(d: ForestDocument, heightMap: GreyMap | null, densityMap: GreyMap | null): Wish {
  const ground = JSON.stringify([d.size, d.terrain, d.terrain.kind === 'map' ? numberOf(heightMap) : 0]);
  const dense = d.density.kind === 'map' ? numberOf(densityMap) : 0;
  return { key: JSON.stringify([d.seed, d.count, d.spacing, d.mix, d.density, dense, d.season, ground]), ground };
}
