import { foundText } from '../file/allowed.ts';
import type { Fault } from '../file/fault.ts';
import { fieldsOf, unknownKeys } from '../file/read.ts';
import type { JsonObject } from '../file/schema.ts';
import { SPECIES_KINDS, type SpeciesFacts } from './species.ts';

/** Measures of `facts`: least and most that they may be, and what they are. */
const RANGES = {
  height: [0.01, 150, 'Height of grown trees, metres.'],
  spread: [0.01, 10, 'Width of the crown as a part of the height.'],
  clear: [0, 1, 'Part of the height below the first branches.'],
} as const;

const TEXTS = { range: 'Where it grows by itself.', source: 'Who measured.' } as const;
const LONGEST = 300;

/** What a file says of the grown trees of its kind, or undefined; faults go on the list. */
export function readFacts(value: unknown, faults: Fault[]): SpeciesFacts | undefined {
  if (value === undefined) return undefined;
  const fields = fieldsOf(value, 'facts', faults);
  if (!fields) return undefined;
  const before = faults.length;
  unknownKeys(fields, 'facts.', ['kind', ...Object.keys(RANGES), ...Object.keys(TEXTS)], faults);
  const { kind } = fields;
  if (!SPECIES_KINDS.some((k) => k === kind))
    faults.push({ path: 'facts.kind', found: foundText(kind), allowed: SPECIES_KINDS.join(', ') });
  const read: Record<string, unknown> = { kind };
  for (const [key, [least, most]] of Object.entries(RANGES)) {
    const range = fields[key];
    const good =
      Array.isArray(range) &&
      range.length === 2 &&
      range.every((x) => typeof x === 'number' && x >= least && x <= most) &&
      range[0] <= range[1];
    if (good) read[key] = range;
    else {
      const allowed = `two numbers from ${least} to ${most}, the smaller first`;
      faults.push({ path: `facts.${key}`, found: foundText(range), allowed });
    }
  }
  for (const key of Object.keys(TEXTS)) {
    const text = fields[key];
    if (typeof text === 'string' && text.length <= LONGEST) read[key] = text;
    else
      faults.push({ path: `facts.${key}`, found: foundText(text), allowed: `a text of up to ${LONGEST} characters` });
  }
  return faults.length === before ? (read as unknown as SpeciesFacts) : undefined;
}

/** The JSON Schema of `facts`. */
export function factsSchema(): JsonObject {
  const range = ([least, most, description]: readonly [number, number, string]): JsonObject => ({
    type: 'array',
    description,
    minItems: 2,
    maxItems: 2,
    items: { type: 'number', minimum: least, maximum: most },
  });
  return {
    type: 'object',
    description: 'What a botanist measures on grown trees of the kind.',
    properties: {
      kind: { enum: SPECIES_KINDS },
      ...Object.fromEntries(Object.entries(RANGES).map(([key, row]) => [key, range(row)])),
      ...Object.fromEntries(
        Object.entries(TEXTS).map(([key, description]) => [key, { type: 'string', maxLength: LONGEST, description }]),
      ),
    },
    required: ['kind', ...Object.keys(RANGES), ...Object.keys(TEXTS)],
    additionalProperties: false,
  };
}
