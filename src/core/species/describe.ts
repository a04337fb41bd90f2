import { describeTable } from '../file/describe.ts';
import { GROUPS } from './parameters.ts';

/** The page docs/parameters.md, made from the parameter table. */
export function describeParameters(): string {
  const lines = [
    '# Parameters of a species',
    '',
    'Made from the parameter table in `src/core/species`; do not edit by hand. Symbols and sections are those of Weber & Penn, "Creation and',
    'Rendering of Realistic Trees", 1995. Parameters without a symbol are Windgrove\'s own; a file may leave them out and gets the default.',
    'A species file also has `format` ("windgrove-species"), `version` (1), `name`, `latin` and `source`.',
    '',
    ...GROUPS.flatMap(describeTable),
  ];
  return `${lines.join('\n').trimEnd()}\n`;
}
