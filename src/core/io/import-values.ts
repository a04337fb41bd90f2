import { oneLine } from '../file/one-line.ts';
import type { Parameter } from '../file/parameter.ts';
import type { ParameterValue } from '../species/edits.ts';
import { defaultOf, GROUPS, isRequired, MOST_LEVELS } from '../species/parameters.ts';
import { type ParsedSpecies, parseSpecies } from '../species/parse.ts';

type Part = Record<string, ParameterValue>;

/** The parts of a species in which every parameter has its default: one a group, and for `levels` one a level. */
function plainParts(): Map<string, Part> {
  const valuesOf = (parameters: readonly Parameter[], level: number): Part =>
    Object.fromEntries(
      parameters
        .map((p) => [p.key, isRequired(p, level) ? (p.default ?? 0) : defaultOf(p, level)] as const)
        .filter((entry): entry is [string, ParameterValue] => entry[1] !== undefined),
    );
  const parts = new Map<string, Part>();
  for (const { group, parameters } of GROUPS) {
    if (group !== 'levels') parts.set(group, valuesOf(parameters, 0));
    else for (let level = 0; level < MOST_LEVELS; level++) parts.set(`levels.${level}`, valuesOf(parameters, level));
  }
  return parts;
}

/** Digits behind the point that a value keeps: what a conversion carries further is noise. */
const rounded = (value: number): number => Math.round(value * 10_000) / 10_000;

/** A value as the parameter may have it, the nearest one where it may not. */
function nearestAllowed(parameter: Parameter, value: ParameterValue): ParameterValue {
  if (parameter.kind !== 'number' || typeof value !== 'number') return value;
  const whole = parameter.integer ? Math.round(value) : rounded(value);
  return Math.min(Math.max(whole, parameter.min), parameter.max);
}

/**
 * The species that an import makes of values by path (`levels.1.length`), with defaults for the rest. What is beyond the range of a
 * parameter becomes the nearest that is allowed, and a note on the list names it. Numbers must be finite, paths those of parameters.
 */
export function speciesOf(
  name: string,
  source: string,
  values: Readonly<Record<string, ParameterValue>>,
  notes: string[],
): ParsedSpecies {
  const limited: string[] = [];
  const parts = plainParts();
  for (const [path, value] of Object.entries(values)) {
    const dot = path.lastIndexOf('.');
    const [part, key] = [parts.get(path.slice(0, dot)), path.slice(dot + 1)];
    const parameter = GROUPS.find(({ group }) => group === path.split('.')[0])?.parameters.find((p) => p.key === key);
    if (!part || !parameter) throw new Error(`There is no parameter ${path}`);
    const fit = nearestAllowed(parameter, value);
    part[key] = fit;
    if (typeof fit === 'number' && typeof value === 'number' && Math.abs(fit - value) > 1e-3 * Math.abs(fit) + 1e-4)
      limited.push(`${path} ${rounded(value)} became ${fit}`);
  }
  if (limited.length > 0) notes.push(`Brought within what Windgrove allows: ${limited.join(', ')}.`);
  const levels = Array.from({ length: MOST_LEVELS }, (_, level) => parts.get(`levels.${level}`));
  const groups = GROUPS.map(({ group }) => [group, group === 'levels' ? levels : parts.get(group)]);
  return parseSpecies({
    format: 'windgrove-species',
    version: 1,
    name: oneLine(name, 70).trim() || 'Imported tree',
    source,
    ...Object.fromEntries(groups),
  });
}
