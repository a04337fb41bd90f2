import type { Parameter } from './parameter.ts';
import type { Group } from './parameters.ts';
import { defaultOf, GROUPS, isRequired, MOST_LEVELS } from './parameters.ts';

/** A JSON value. */
export type Json = string | number | boolean | null | readonly Json[] | { readonly [key: string]: Json };
type JsonObject = { readonly [key: string]: Json };

/** The schema of one parameter. */
function parameterSchema(p: Parameter, level: number): JsonObject {
  const notes = [p.help];
  if (p.kind === 'number' && p.negative) notes.push(p.negative);
  if (p.symbol) notes.push(`Weber & Penn 1995: ${p.symbol}, ${p.section}.`);
  const value = defaultOf(p, level);
  const common: JsonObject = {
    title: p.label,
    description: notes.join(' '),
    ...(value === undefined ? {} : { default: value as Json }),
  };
  switch (p.kind) {
    case 'number':
      return { ...common, type: p.integer ? 'integer' : 'number', minimum: p.min, maximum: p.max };
    case 'numbers':
      return {
        ...common,
        type: 'array',
        minItems: 1,
        maxItems: 8,
        items: { type: 'number', minimum: p.min, maximum: p.max },
      };
    case 'flag':
      return { ...common, type: 'boolean' };
    case 'choice':
      return { ...common, type: 'string', enum: p.choices };
    case 'colour':
      return { ...common, type: 'string', pattern: '^#[0-9a-fA-F]{6}$' };
  }
}

function groupSchema(group: Group, level = 0): JsonObject {
  return {
    type: 'object',
    description: group.help,
    properties: Object.fromEntries(group.parameters.map((p) => [p.key, parameterSchema(p, level)])),
    required: group.parameters.filter((p) => isRequired(p, level)).map((p) => p.key),
    additionalProperties: false,
  };
}

/** The JSON Schema (2020-12) of a species file, made from the parameter table; shipped as public/species/species.schema.json. */
export function speciesJsonSchema(): JsonObject {
  const properties: Record<string, Json> = {
    $schema: { type: 'string' },
    format: { const: 'windgrove-species' },
    version: { const: 1 },
    name: { type: 'string', minLength: 1, maxLength: 80 },
    latin: { type: 'string', maxLength: 80 },
    source: { type: 'string', maxLength: 400, description: 'Where the numbers come from.' },
  };
  const required = ['format', 'version', 'name'];
  for (const group of GROUPS) {
    if (group.group === 'levels') {
      properties.levels = {
        type: 'array',
        description: group.help,
        minItems: 1,
        maxItems: MOST_LEVELS,
        prefixItems: [groupSchema(group, 0)],
        items: groupSchema(group, 1),
      };
    } else {
      properties[group.group] = groupSchema(group);
    }
    if (group.parameters.some((p) => isRequired(p, 1))) required.push(group.group);
  }
  return {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    title: 'Windgrove species',
    type: 'object',
    properties,
    required,
    additionalProperties: false,
  };
}
