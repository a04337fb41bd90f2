import { isAllowed } from '../file/allowed.ts';
import type { Parameter } from './parameter.ts';
import { GROUPS, MOST_LEVELS } from './parameters.ts';
import type { Species } from './species.ts';

/** A value of a parameter, as a file has it. */
export type ParameterValue = string | number | boolean | null | readonly number[];

/**
 * What was changed of a species: values by path, `levels.1.downAngle`, `bark.colour`; levels count from 0, the trunk. `null` where a
 * parameter that may be absent was taken out. The keys stand in the order of the table, and no value is that of the species.
 */
export type SpeciesEdits = Readonly<Record<string, ParameterValue>>;

/** A parameter and where it stands in a species. */
export interface ParameterPlace {
  readonly path: string;
  readonly parameter: Parameter;
  /** Level of the stems, 0 the trunk; undefined outside of `levels`. */
  readonly level?: number;
}

/** What branches read and a trunk too: how many trunks there are, and how far they lean (weber-penn.md, row 52). */
const TRUNKS_TOO: readonly string[] = ['branches', 'downAngle', 'downAngleV'];

/** Whether stems of a level read the parameter. */
const isRead = ({ levels, key }: Parameter, level: number): boolean =>
  levels === undefined || (level === 0) === (levels === 'trunk') || (level === 0 && TRUNKS_TOO.includes(key));

/** Every place of a species that has a parameter, by path, in the order of the table. */
export const PLACES: ReadonlyMap<string, ParameterPlace> = new Map(
  GROUPS.flatMap(({ group, parameters }) => {
    if (group !== 'levels') return parameters.map((parameter) => place(`${group}.${parameter.key}`, parameter));
    const levels = Array.from({ length: MOST_LEVELS }, (_, level) => level);
    return levels.flatMap((level) =>
      parameters
        .filter((p) => isRead(p, level))
        .map((parameter) => place(`levels.${level}.${parameter.key}`, parameter, level)),
    );
  }).map((each) => [each.path, each]),
);

function place(path: string, parameter: Parameter, level?: number): ParameterPlace {
  return level === undefined ? { path, parameter } : { path, parameter, level };
}

type Tree = Record<string, unknown>;

/** The part of a species in which a path ends, and the key there. Levels that a file does not list are its last. */
function partAt(species: Species, path: string): readonly [part: Tree, key: string] {
  const [group, ...rest] = path.split('.') as [string, ...string[]];
  const { levels } = species;
  if (group === 'levels') return [levels[Math.min(Number(rest[0]), levels.length - 1)] as unknown as Tree, rest[1]!];
  return [species[group as keyof Species] as unknown as Tree, rest[0]!];
}

/** The value at a path of PLACES; null where the parameter is absent. */
export function valueAt(species: Species, path: string): ParameterValue {
  const [part, key] = partAt(species, path);
  return (part[key] as ParameterValue | undefined) ?? null;
}

/** Whether two values are the same, number by number. */
export const sameValue = (a: ParameterValue, b: ParameterValue): boolean =>
  a === b || (Array.isArray(a) && Array.isArray(b) && a.length === b.length && a.every((x, i) => x === b[i]));

/** Whether a path may have this value: one that the parameter allows, or null where it may be absent. */
export function mayBe(path: string, value: unknown): value is ParameterValue {
  const found = PLACES.get(path);
  if (!found) return false;
  const { parameter } = found;
  return isAllowed(parameter, value) || (value === null && parameter.default === undefined && !!parameter.optional);
}

/**
 * The species with the edits in it; what is edited is new, the rest is shared.
 *
 * Paths must be of PLACES and values allowed (`mayBe`). An edit of a level that the species does not list adds the levels up to it, as
 * copies of its last.
 */
export function editSpecies(species: Species, edits: SpeciesEdits): Species {
  const entries = Object.entries(edits);
  if (entries.length === 0) return species;
  const parts = new Map<unknown, Tree>();
  const copy = (part: unknown): Tree => {
    const made = parts.get(part) ?? { ...(part as Tree) };
    parts.set(part, made);
    return made;
  };
  const deepest = Math.max(-1, ...entries.map(([path]) => PLACES.get(path)?.level ?? -1));
  const edited: Tree = { ...species };
  const levels: Tree[] = species.levels.map(copy);
  while (levels.length <= deepest) levels.push({ ...levels.at(-1) });
  edited.levels = levels;
  for (const [path, value] of entries) {
    const [group, ...rest] = path.split('.') as [string, ...string[]];
    const part = group === 'levels' ? levels[Number(rest[0])]! : copy(species[group as keyof Species]);
    if (group !== 'levels') edited[group] = part;
    const key = rest.at(-1)!;
    if (
      value === null &&
      PLACES.get(path)?.parameter.default === undefined &&
      !isAllowed(PLACES.get(path)!.parameter, null)
    )
      delete part[key];
    else part[key] = value;
  }
  return edited as unknown as Species;
}

/** The edits that make `species` of `base`, in the order of the table. */
export function editsBetween(base: Species, species: Species): SpeciesEdits {
  const edits: Record<string, ParameterValue> = {};
  for (const path of PLACES.keys()) {
    const level = PLACES.get(path)!.level;
    if (level !== undefined && level >= Math.max(base.levels.length, species.levels.length)) continue;
    const value = valueAt(species, path);
    if (!sameValue(value, valueAt(base, path))) edits[path] = value;
  }
  return edits;
}

/** `edits` with `path` at `value`: without it where that is the value of the base. */
export function withEdit(base: Species, edits: SpeciesEdits, path: string, value: ParameterValue): SpeciesEdits {
  const { [path]: _, ...others } = edits;
  if (sameValue(value, valueAt(base, path))) return others;
  const all: Record<string, ParameterValue> = { ...others, [path]: value };
  return Object.fromEntries([...PLACES.keys()].filter((p) => Object.hasOwn(all, p)).map((p) => [p, all[p]!]));
}
