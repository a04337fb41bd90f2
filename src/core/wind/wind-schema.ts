import { type JsonObject, objectSchema, parameterSchema } from '../file/schema.ts';
import { WIND_TEXTS } from './parse-wind.ts';
import { MOST_SAMPLES, RECORD_LIMITS } from './record-file.ts';
import { WIND_PARTS, type WindPart } from './wind-parameters.ts';

const propertiesOf = ({ parameters }: WindPart): JsonObject =>
  Object.fromEntries(parameters.map((p) => [p.key, parameterSchema(p, p.default)]));

const partSchema = (part: WindPart): JsonObject => objectSchema(part.help, propertiesOf(part));

const listSchema = ({ most = 1, ...part }: WindPart): JsonObject => ({
  type: 'array',
  description: part.help,
  maxItems: most,
  items: objectSchema('', propertiesOf(part)),
});

const numbers = ({ min, max }: { min: number; max: number }, description: string): JsonObject => ({
  type: 'array',
  description,
  minItems: 2,
  maxItems: MOST_SAMPLES,
  items: { type: 'number', minimum: min, maximum: max },
});

/** What a record may be: none, the name of a file beside, or its samples. */
const RECORD: JsonObject = {
  description: 'A wind that was measured and plays around and around, beside the waves.',
  default: null,
  oneOf: [
    { type: 'null' },
    { type: 'string', pattern: '^[\\w-][\\w.-]*\\.[cC][sS][vV]$', description: 'A CSV file beside this one.' },
    objectSchema(
      'Its samples, at equal steps.',
      {
        name: { type: 'string', maxLength: 80 },
        step: {
          type: 'number',
          minimum: RECORD_LIMITS.step.min,
          maximum: RECORD_LIMITS.step.max,
          description: 'Seconds from sample to sample.',
        },
        speed: numbers(RECORD_LIMITS.speed, 'Metres a second.'),
        direction: numbers(RECORD_LIMITS.direction, 'Degrees, towards which it blows: 0 along x, 90 along y.'),
      },
      ['name', 'step', 'speed', 'direction'],
    ),
  ],
};

/** The JSON Schema (2020-12) of a wind file, made from the parameter table; shipped as public/winds/wind.schema.json. */
export function windJsonSchema(): JsonObject {
  const { whole, waves, gusts, profile, spring, springLevels, sway } = WIND_PARTS;
  return {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    title: 'Windgrove wind',
    type: 'object',
    properties: {
      $schema: { type: 'string' },
      format: { const: 'windgrove-wind' },
      version: { const: 1 },
      name: { type: 'string', minLength: 1, maxLength: WIND_TEXTS.name.longest },
      description: { type: 'string', maxLength: WIND_TEXTS.description.longest, description: 'One sentence.' },
      ...propertiesOf(whole),
      waves: listSchema(waves),
      gusts: listSchema(gusts),
      profile: partSchema(profile),
      spring: objectSchema(spring.help, { ...propertiesOf(spring), levels: listSchema(springLevels) }),
      sway: partSchema(sway),
      record: RECORD,
    },
    required: ['format', 'version', 'name'],
    additionalProperties: false,
  };
}
