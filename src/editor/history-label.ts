import { ALL_LEVELS } from '../core/link/link.ts';
import { type ParameterValue, PLACES, valueAt } from '../core/species/edits.ts';
import type { Species } from '../core/species/species.ts';
import { windLabel } from './history-label-wind.ts';
import { differences, type Made } from './made.ts';
import { valueText } from './ui/tree/value-text.ts';
import { stepWords as words } from './words/history.ts';

/** What labels need to know besides the states. */
export interface Names {
  /** The species of a state without its edits; null where it is not at hand. */
  base(made: Made): Species | null;
  /** Name of the species of a state. */
  species(made: Made): string;
}

/** Letters of a value that a label has room for. */
const LONGEST_VALUE = 24;

const parameterName = (path: string): string => {
  const { parameter, level } = PLACES.get(path)!;
  return level === undefined ? parameter.label : words.parameterOf(parameter.label, words.level(level));
};

/** A value in a few letters; null: it has too many. */
function shortValue(path: string, value: ParameterValue | undefined): string | null {
  if (value === undefined) return null;
  const text = valueText(path, value);
  return text.length <= LONGEST_VALUE ? text : null;
}

/** What was changed of the parameters; null: nothing. */
function editsLabel(before: Made, after: Made, names: Names): string | null {
  const paths = [...new Set(differences(before.edits, after.edits).map(placeOf))].filter((path) => PLACES.has(path));
  if (paths.length === 0) return null;
  if (paths.length > 1) {
    if (Object.keys(after.edits).length === 0) return words.resetAll;
    const levels = new Set(paths.map((path) => PLACES.get(path)!.level));
    const [level] = levels;
    const count = words.parameters(paths.length);
    return levels.size === 1 && level !== undefined ? words.parameterOf(count, words.level(level)) : count;
  }
  const path = paths[0]!;
  const name = parameterName(path);
  const base = names.base(after);
  const valueIn = (made: Made): ParameterValue | undefined =>
    Object.hasOwn(made.edits, path) ? made.edits[path]! : base ? valueAt(base, path) : undefined;
  const to = shortValue(path, valueIn(after));
  if (to === null) return Object.hasOwn(after.edits, path) ? name : words.reset(name);
  return words.value(name, shortValue(path, valueIn(before)), to);
}

/** The path of the parameter in which a difference lies: lists differ number by number. */
const placeOf = (path: string): string => (PLACES.has(path) ? path : path.replace(/\.\d+$/, ''));

/** What was changed of how it is shown. */
function viewLabels(before: Made, after: Made): string[] {
  const labels: string[] = [];
  const { overlays, probe, levelsShown, showLeaves, view } = after;
  if (view !== before.view) labels.push(words.view[view]);
  if (after.season !== before.season) labels.push(words.season[after.season]);
  if (after.stage !== before.stage) labels.push(words.stage[after.stage]);
  if (after.hour !== before.hour) labels.push(after.hour === null ? words.hourOfStage : words.hour(after.hour));
  if (levelsShown !== before.levelsShown)
    labels.push(words.drawnTo[levelsShown >= ALL_LEVELS ? 3 : Math.min(3, levelsShown - 1)]!);
  if (showLeaves !== before.showLeaves) labels.push(words[showLeaves ? 'on' : 'off'](words.leaves));
  for (const key of ['arrows', 'fronts', 'handle'] as const) {
    if (overlays[key] !== before.overlays[key]) labels.push(words[overlays[key] ? 'on' : 'off'](words.overlays[key]));
  }
  if (labels.length === 0 && probe !== before.probe) labels.push(probe === null ? words.probeGone : words.probe);
  return labels;
}

/** What was changed of the two winds that are compared. */
function compareLabel(before: Made, after: Made): string | null {
  const [was, is] = [before.compare, after.compare];
  if (!was && !is) return null;
  if (!was) return words.compared;
  if (!is) return words.comparisonEnded;
  if (is.layout !== was.layout) return words[is.layout];
  const inB = windLabel(was, is);
  if (inB !== null) return words.ofB(inB);
  return is.at === was.at ? null : words.divider;
}

/** Both winds changed places, and nothing else was done. */
const swapped = (before: Made, after: Made): boolean =>
  !!before.compare &&
  !!after.compare &&
  differences(before.wind, after.compare.wind).length === 0 &&
  differences(before.compare.wind, after.wind).length === 0 &&
  differences(before.wind, after.wind).length > 0;

/** What was done from one state to the next, in a few words: `Down angle of limbs 45° → 50°`, `Seed 7`, `Wave 2 amplitude`. */
export function changeLabel(before: Made, after: Made, names: Names): string {
  const { species, ownSpecies } = after;
  const wind = swapped(before, after) ? words.swapped : windLabel(before, after);
  if (species !== before.species || ownSpecies !== before.ownSpecies)
    return words[wind === null ? 'tree' : 'treeAndWind'](names.species(after));
  const labels: (string | null)[] = [editsLabel(before, after, names)];
  if (after.seed !== before.seed) labels.push(words.seed(after.seed));
  if (after.treeName !== before.treeName)
    labels.push(after.treeName === null ? words.unnamed : words.called(after.treeName));
  labels.push(wind);
  if (wind !== words.swapped) labels.push(compareLabel(before, after));
  // A whole wind that is chosen is switched on with it.
  const switched = after.blowing !== before.blowing && !(wind !== null && after.blowing);
  if (switched) labels.push(words[after.blowing ? 'on' : 'off'](words.windBlows));
  labels.push(...viewLabels(before, after));
  const [first, ...more] = labels.filter((label) => label !== null);
  if (first === undefined) return words.nothing;
  return more.length === 0 ? first : words.more(first, more.length);
}
