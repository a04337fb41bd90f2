import type { FoliageLook, OrganLook } from '../species/species.ts';

/** Leaves that are there, of `places`: the first of the draw order, which any number of is spread evenly over the crown. */
export const coverCount = (places: number, { cover }: Pick<FoliageLook, 'cover'>): number => Math.round(places * cover);

/** Organs that are there, of as many places of leaves. */
export const organCount = (places: number, { kind, share }: Pick<OrganLook, 'kind' | 'share'>): number =>
  kind === 'none' ? 0 : Math.round(places * share);
