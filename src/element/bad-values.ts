import { ATTRIBUTES, attributeFault, readProperty } from './attributes.ts';
import type { ErrorType } from './element-events.ts';
import { STATE_ATTRIBUTES } from './element-state.ts';

/** Whether something has a name and lists of these names: enough that nothing breaks before it is grown or blows. */
const has = (value: unknown, lists: readonly string[]): boolean =>
  typeof value === 'object' &&
  value !== null &&
  typeof (value as Record<string, unknown>).name === 'string' &&
  lists.every((list) => Array.isArray((value as Record<string, unknown>)[list]));

/** Properties that no attribute sets, what they hold, and what such a thing has. */
const DATA = [
  ['speciesData', 'species', 'a species as `loadSpecies` gives it', ['levels']],
  ['windData', 'wind', 'a wind as `loadWind` gives it', ['waves', 'gusts']],
] as const;

/** Finds what has changed to something that may not be, tells each, and puts back what stood there before. */
export function putBackBad(
  element: object,
  changed: ReadonlyMap<PropertyKey, unknown>,
  tell: (type: ErrorType, message: string) => void,
): void {
  const own = element as Record<string, unknown>;
  for (const name of STATE_ATTRIBUTES) {
    const { property: key, usual } = ATTRIBUTES[name];
    if (!changed.has(key)) continue;
    const value = readProperty(name, own[key]);
    if (value === undefined) tell('attribute', attributeFault(name, own[key]));
    own[key] = value === undefined ? (changed.get(key) ?? usual) : value;
  }
  for (const [key, type, allowed, lists] of DATA) {
    if (!changed.has(key) || own[key] === null || has(own[key], lists)) continue;
    tell(type, `${key} is not allowed: it may be ${allowed}, or null.`);
    own[key] = changed.get(key) ?? null;
  }
}
