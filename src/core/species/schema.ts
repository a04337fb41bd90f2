import { type Json, type JsonObject, parameterSchema } from '../file/schema.ts';
import { factsSchema } from './facts.ts';
import type { Group } from './parameters.ts';
import { defaultOf, GROUPS, isRequired, MOST_LEVELS } from './parameters.ts';

function groupSchema(group: Group, level = 0): JsonObject {
  const schemas = group.parameters.map((p) => [p.key, parameterSchema(p, defaultOf(p, level), 'Weber & Penn 1995')]);
  return {
    type: 'object',
    description: group.help,
    properties: Object.fromEntries(schemas),
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
    description: { type: 'string', maxLength: 900, description: 'What it is and how one tells it, one paragraph.' },
    facts: factsSchema(),
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
