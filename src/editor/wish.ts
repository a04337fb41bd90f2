import type { LinkDocument } from '../core/link/link.ts';
import { PLACES, type SpeciesEdits, sameValue } from '../core/species/edits.ts';

/** What of a document says which tree stands. */
export type Wish = Pick<LinkDocument, 'species' | 'ownSpecies' | 'edits' | 'seed' | 'treeName'>;

export const wishOf = ({ species, ownSpecies, edits, seed, treeName }: Wish): Wish => ({
  species,
  ownSpecies,
  edits,
  seed,
  treeName,
});

/** Paths at which two species of the same base differ. */
export const changedPaths = (a: SpeciesEdits, b: SpeciesEdits): string[] =>
  a === b
    ? []
    : [...new Set([...Object.keys(a), ...Object.keys(b)])].filter(
        (path) => !(Object.hasOwn(a, path) && Object.hasOwn(b, path) && sameValue(a[path]!, b[path]!)),
      );

/** Parameters that growing, fitting and packing do not read: a tree of which they change stands as it is. */
const LOOKS = new Set(
  [...PLACES.keys()].filter(
    (path) =>
      (path.startsWith('bark.') || path.startsWith('foliage.') || path.startsWith('wind.flutter')) &&
      path !== 'foliage.size',
  ),
);

/** Whether two wishes are of the same species. */
export const sameSource = (a: Wish, b: Wish): boolean => a.species === b.species && a.ownSpecies === b.ownSpecies;

/** Whether two wishes are the same tree, whatever it looks like. */
export const sameGrowth = (a: Wish, b: Wish): boolean =>
  sameSource(a, b) && a.seed === b.seed && changedPaths(a.edits, b.edits).every((path) => LOOKS.has(path));

/** Whether two wishes are the same tree that looks the same and has the same name. */
export const sameWish = (a: Wish, b: Wish): boolean =>
  sameSource(a, b) && a.seed === b.seed && a.treeName === b.treeName && changedPaths(a.edits, b.edits).length === 0;
