import { describeTable } from '../file/describe.ts';
import { MOST_SAMPLES, RECORD_LIMITS } from './record-file.ts';
import { DRAG_EXPONENT, forceOfSpeed } from './speed.ts';
import { WIND_PARTS } from './wind-parameters.ts';

/** The page docs/wind-parameters.md, made from the parameter table. */
export function describeWindParameters(): string {
  const { step, speed, direction } = RECORD_LIMITS;
  const lines = [
    '# Parameters of a wind',
    '',
    'Made from the parameter table in `src/core/wind`; do not edit by hand. Symbols are those of the paper that is named beside them. A wind',
    'file has `format` ("windgrove-wind"), `version` (1) and `name`, and may have `description`, one sentence; whatever else it leaves out has',
    'the default below. `windgrove validate FILE...` checks files; `public/winds` has examples, and a JSON schema for editors.',
    '',
    'The unit of force is the metre: what the wind pushes the tip of a branch of 3 m and stiffness 1 aside by. Leaves and twigs fold, so that the',
    `drag of a tree grows less than with the square of the speed U: a wind of U m/s is ${forceOfSpeed(1)} U^${DRAG_EXPONENT} m (Vogel 1989), ${forceOfSpeed(4.4).toFixed(1)} m in a gentle`,
    `breeze of 4.4 m/s and ${forceOfSpeed(26.5).toFixed(1)} m in a storm of 26.5 m/s. Directions are those in which the wind travels, in degrees from x (right in`,
    'the first view, east) to y (away from you, north).',
    '',
    ...Object.values(WIND_PARTS).flatMap(describeTable),
    '## Record: `record`',
    '',
    'A measured wind that plays around and around beside the waves. One of:',
    '',
    '- `null`: none.',
    '- The name of a CSV file beside this one, as `"kaimal-sample.csv"`.',
    '- An object with `name`, `step` (seconds from sample to sample, ' +
      `${step.min} to ${step.max}), \`speed\` (a list of 2 to ${MOST_SAMPLES} numbers from ${speed.min} to ${speed.max} m/s) and`,
    `  \`direction\` (as many numbers from ${direction.min} to ${direction.max} degrees, towards which it blows).`,
    '',
    'A CSV file has a header that names its columns and units:',
    '',
    '| column | headed as | values |',
    '|---|---|---|',
    '| time | `time (s)`, `time (min)`, `timestamp` | seconds or minutes, or stamps as 2024-05-31T12:00:00.2Z; growing from line to line |',
    `| speed | \`speed (m/s)\`, \`speed (km/h)\`, \`speed (knots)\`, \`speed (mph)\` | ${speed.min} to ${speed.max} m/s |`,
    '| direction | `direction (deg)`; may be missing | degrees clockwise from north, **from** which the wind comes, as meteorologists say it |',
    '',
    'Commas, semicolons or tabs stand between the columns; decimals have a point, or a comma where no comma separates. Lines behind `#` are',
    'remarks. Missing values (nothing, `NaN`, `-`, 999) and gaps of up to 10 steps or 10 seconds are filled in between their neighbours, uneven',
    'steps are resampled to the usual one, and the reader is told; anything else that is wrong is a fault with the number of its line.',
  ];
  return `${lines.join('\n').trimEnd()}\n`;
}
