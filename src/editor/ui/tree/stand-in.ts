import { parametersOf } from '../../../core/grow/plan.ts';
import { type ParameterValue, PLACES } from '../../../core/species/edits.ts';
import type { LevelParameters, Species } from '../../../core/species/species.ts';
import { treeWords } from '../../words/tree.ts';

/** What of a species a season changes, by the key of the season. */
const OF_SUMMER: Readonly<Record<string, (species: Species) => ParameterValue | undefined>> = {
  cover: ({ foliage }) => foliage.cover,
  colour: ({ foliage }) => foliage.colour,
  second: ({ foliage }) => foliage.second,
  secondShare: ({ foliage }) => foliage.secondShare,
  under: ({ foliage }) => foliage.under,
  glow: ({ foliage }) => foliage.glow,
  organ: ({ organ }) => organ.kind,
  organShare: ({ organ }) => organ.share,
  organSize: ({ organ }) => organ.size,
  organColour: ({ organ }) => organ.colour,
};

const LEAF_ANGLES: readonly string[] = ['downAngle', 'downAngleV', 'rotate', 'rotateV'];

export const isOfSeason = (path: string): boolean => /^(spring|autumn|winter)\./.test(path);

/** What holds where a parameter is absent: summer's value in a season, that of the stems' level for a leaf's angle; null: nothing. */
export function standIn(species: Species, path: string): ParameterValue {
  const { group, key } = PLACES.get(path)!.parameter;
  if (isOfSeason(path)) return OF_SUMMER[key]?.(species) ?? null;
  if (group === 'leaves' && LEAF_ANGLES.includes(key))
    return parametersOf(species, species.tree.levels)[key as keyof LevelParameters] ?? null;
  return null;
}

/** The same in words, for a number; '' where there is nothing to say. */
export function standInText(species: Species, path: string): string {
  if (isOfSeason(path)) return treeWords.asSummerSays;
  if (standIn(species, path) === null) return '';
  return treeWords.inherited(treeWords.levels[Math.min(species.tree.levels, 3)]!);
}
