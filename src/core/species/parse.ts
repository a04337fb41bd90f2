import { type Fault, readJson } from '../file/fault.ts';
import {
  type Absent,
  type Fields,
  fieldsOf,
  hasFormat,
  listOf,
  readParameters,
  readTexts,
  unknownKeys,
} from '../file/read.ts';
import { readFacts } from './facts.ts';
import type { Group } from './parameters.ts';
import { defaultOf, GROUPS, isRequired, MOST_LEVELS } from './parameters.ts';
import type { Species } from './species.ts';

export type ParsedSpecies =
  | { readonly species: Species; readonly faults?: undefined }
  | { readonly species?: undefined; readonly faults: readonly Fault[] };

/** A species file is a few kilobytes; this much is something else. */
const LONGEST = 1_000_000;

/** Letters of a species' name, at most. */
export const LONGEST_NAME = 80;

/** The texts at the head of a file. */
const TEXTS = {
  name: { longest: LONGEST_NAME, required: true },
  latin: { longest: 80 },
  source: { longest: 400 },
  description: { longest: 900 },
} as const;

/**
 * A species from the text of a file, or from what JSON.parse made of it; every fault where there are any, each with its path.
 *
 * The paper's parameters must all be there. Windgrove's own may be left out and are filled in from the parameter table. Never throws.
 */
export function parseSpecies(file: unknown): ParsedSpecies {
  if (typeof file !== 'string') return readSpecies(file);
  const { value, fault } = readJson(file, 'a species', LONGEST);
  return fault ? { faults: [fault] } : readSpecies(value);
}

function readSpecies(value: unknown): ParsedSpecies {
  const faults: Fault[] = [];
  const file = fieldsOf(value, '', faults);
  if (!file || !hasFormat(file, 'windgrove-species', faults)) return { faults };
  const groupNames = GROUPS.map((group) => group.group);
  unknownKeys(file, '', ['format', 'version', ...Object.keys(TEXTS), 'facts', ...groupNames, '$schema'], faults);
  const species: Record<string, unknown> = {
    format: 'windgrove-species',
    version: 1,
    ...readTexts(file, TEXTS, faults),
  };
  const facts = readFacts(file.facts, faults);
  if (facts) species.facts = facts;
  for (const group of GROUPS) {
    const content = file[group.group];
    species[group.group] =
      group.group === 'levels' ? readLevels(group, content, faults) : readGroup(group, content, group.group, 0, faults);
  }
  return faults.length > 0 ? { faults } : { species: species as unknown as Species };
}

function readLevels(group: Group, value: unknown, faults: Fault[]): Fields[] {
  const allowed = `a list of 1 to ${MOST_LEVELS} levels, the trunk first`;
  const levels = listOf(value, [1, MOST_LEVELS], 'levels', allowed, faults) ?? [];
  return levels.map((entry, level) => readGroup(group, entry, `levels[${level}]`, level, faults));
}

/** The parameters of a group at their place in the file, with defaults filled in; faults go on the list. */
function readGroup({ parameters }: Group, value: unknown, path: string, level: number, faults: Fault[]): Fields {
  const optional = !parameters.some((p) => isRequired(p, level));
  const fields = value === undefined && optional ? {} : fieldsOf(value, path, faults);
  if (!fields) return {};
  const keys = parameters.map((p) => p.key);
  unknownKeys(fields, `${path}.`, keys, faults);
  const absent: Absent = { isRequired: (p) => isRequired(p, level), defaultOf: (p) => defaultOf(p, level) };
  return readParameters(parameters, fields, `${path}.`, absent, faults);
}
