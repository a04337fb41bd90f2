import type { Parameter } from './parameter.ts';

/** A JSON value. */
export type Json = string | number | boolean | null | readonly Json[] | { readonly [key: string]: Json };
export type JsonObject = { readonly [key: string]: Json };

/** The schema of one parameter; `source` is the paper whose symbols and sections a table names, as far as the rows do not. */
export function parameterSchema(p: Parameter, value: Parameter['default'], source = ''): JsonObject {
  const notes = [p.help];
  if (p.kind === 'number' && p.negative) notes.push(p.negative);
  if (p.kind === 'number' && p.orNull) notes.push(`null: ${p.orNull}.`);
  if (p.symbol) notes.push(`${source && `${source}: `}${p.symbol}, ${p.section}.`);
  const common: JsonObject = {
    title: p.label,
    description: notes.join(' '),
    ...(value === undefined ? {} : { default: value as Json }),
  };
  switch (p.kind) {
    case 'number': {
      const type = p.integer ? 'integer' : 'number';
      return { ...common, type: p.orNull ? [type, 'null'] : type, minimum: p.min, maximum: p.max };
    }
    case 'numbers':
      return {
        ...common,
        type: 'array',
        minItems: p.least ?? 1,
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

/** The schema of an object that has these properties and no others. */
export const objectSchema = (
  description: string,
  properties: JsonObject,
  required: readonly string[] = [],
): JsonObject => ({
  type: 'object',
  description,
  properties,
  ...(required.length > 0 ? { required } : {}),
  additionalProperties: false,
});
