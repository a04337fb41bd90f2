import { densityAt } from './density.ts';
import type { ForestSpecies, Habitat, HabitatRange } from './forest.ts';
import { type HeightField, heightAt, slopeAt } from './height-field.ts';
import { type WetnessField, wetnessField } from './wetness.ts';

/** What the ground is like at a place: metres, degrees, 0..1. */
export interface Site {
  readonly altitude: number;
  readonly slope: number;
  readonly wetness: number;
}

/** 1 within a range, falling to 0 over its soft edges. */
export function fits({ least, most, soft }: HabitatRange, value: number): number {
  const outside = Math.max(least - value, value - most);
  if (outside <= 0) return 1;
  if (outside >= soft) return 0;
  const x = 1 - outside / soft;
  return x * x * (3 - 2 * x);
}

/** How well a place suits a species, 0..1 (Weber & Penn 1995, section 6). */
export function suitability(where: Habitat | undefined, site: Site): number {
  if (!where) return 1;
  let fit = 1;
  for (const key of ['altitude', 'slope', 'wetness'] as const) {
    const range = where[key];
    if (range) fit *= fits(range, site[key]);
  }
  return fit;
}

/** Asks what the ground is like, as far as a species of the mix wants to know. */
export class Sites {
  readonly #field: HeightField;
  readonly #wetness: WetnessField | null;
  readonly #altitude: boolean;
  readonly #slope: boolean;

  constructor(field: HeightField, mix: readonly ForestSpecies[]) {
    this.#field = field;
    this.#altitude = mix.some(({ where }) => where?.altitude);
    this.#slope = mix.some(({ where }) => where?.slope);
    this.#wetness = mix.some(({ where }) => where?.wetness) ? wetnessField(field) : null;
  }

  at(x: number, y: number): Site {
    return {
      altitude: this.#altitude ? heightAt(this.#field, x, y) : 0,
      slope: this.#slope ? (slopeAt(this.#field, x, y) * 180) / Math.PI : 0,
      wetness: this.#wetness ? densityAt(this.#wetness, x, y) : 0.5,
    };
  }
}
