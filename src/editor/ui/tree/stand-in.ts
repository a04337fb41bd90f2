import { parametersOf } from '../../../core/grow/plan.ts';
import { type ParameterValue, PLACES, valueAt } from '../../../core/species/edits.ts';
import { isOfSeason, summerPath } from '../../../core/species/season.ts';
import type { LevelParameters, Species } from '../../../core/species/species.ts';
import { treeWords } from '../../words/tree.ts';

const LEAF_ANGLES: readonly string[] = ['downAngle', 'downAngleV', 'rotate', 'rotateV'];

/** What holds where a parameter is absent: summer's value in a season, that of the stems' level for a leaf's angle; null: nothing. */
export function standIn(species: Species, path: string): ParameterValue {
  const { group, key } = PLACES.get(path)!.parameter;
  if (isOfSeason(path)) return valueAt(species, summerPath(key));
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
