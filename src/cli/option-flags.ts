import { allowedValues } from '../core/file/allowed.ts';
import { faultText } from '../core/file/fault.ts';
import {
  EXPORT_FORMATS,
  EXPORT_PARAMETERS,
  type ExportFormat,
  type ExportOptions,
  type ExportParameter,
  exportParametersOf,
  readExportOptions,
} from '../core/io/export-options.ts';
import { UsageError } from './failure.ts';

/** Rows that the command calls by another word than the table. */
const WORDS: Readonly<Partial<Record<ExportParameter['key'], string>>> = {
  clip: 'bake',
  boneLevels: 'bones-to',
  rate: 'fps',
};

/** The flag of a row of the options' table, without its dashes: `mostLeaves` is `most-leaves`. */
export const flagOf = ({ key }: ExportParameter): string =>
  WORDS[key] ?? key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** What Node's reader of arguments has to know of the export's flags. */
export const EXPORT_FLAGS: Readonly<Record<string, { type: 'string' | 'boolean' }>> = Object.fromEntries(
  EXPORT_PARAMETERS.map((row) => [flagOf(row), { type: row.kind === 'flag' ? 'boolean' : 'string' }] as const),
);

/** What was given, by flag. */
export type FlagValues = Readonly<Record<string, string | boolean | undefined>>;

/** The options that the flags make, for one format; a flag that says nothing for it is a wrong call. */
export function exportOptionsOf(values: FlagValues, format: ExportFormat): ExportOptions {
  const read = new Set(exportParametersOf(format).map(({ key }) => key));
  const given: Record<string, unknown> = { format };
  for (const row of EXPORT_PARAMETERS) {
    const flag = flagOf(row);
    const text = values[flag];
    if (text === undefined || row.key === 'format') continue;
    if (!read.has(row.key))
      throw new UsageError(`--${flag} says nothing for ${format}: it is read by ${row.formats.join(', ')}.`);
    given[row.key] = row.kind === 'number' ? numberOf(String(text)) : text;
  }
  const { options, faults } = readExportOptions(given);
  if (!faults) return options;
  const flags = new Map<string, string>(EXPORT_PARAMETERS.map((row) => [row.key, flagOf(row)]));
  throw new UsageError(faults.map((fault) => faultText({ ...fault, path: `--${flags.get(fault.path)}` })).join('\n'));
}

/** A number where the text is one; the text itself, which no rule allows, where it is not. */
const numberOf = (text: string): number | string =>
  text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : text;

/** The format of `--format`, or of the ending of `out` where there is none; glb where neither says. */
export function formatOf(format: string | undefined, out: string | undefined): ExportFormat {
  const ending = /\.([a-z]+)$/i.exec(out ?? '')?.[1]?.toLowerCase();
  const asked = format ?? (ending === 'json' ? 'species' : EXPORT_FORMATS.find((each) => each === ending)) ?? 'glb';
  const found = EXPORT_FORMATS.find((each) => each === asked);
  if (found) return found;
  throw new UsageError(`--format: found the text "${asked}"; allowed: ${EXPORT_FORMATS.join(', ')}.`);
}

/** A line of help for every row besides the format. */
export function flagHelp(): string {
  const rows = EXPORT_PARAMETERS.filter(({ key }) => key !== 'format').map((row) => {
    const value = row.kind === 'flag' ? '' : row.kind === 'choice' ? ` ${row.choices.join('|')}` : ' N';
    const otherwise = row.kind === 'flag' ? '' : ` Default ${row.default}.`;
    const range = row.kind === 'number' ? ` ${allowedValues(row).replace(/^a/, 'A')}.` : '';
    return [`--${flagOf(row)}${value}`, `${row.help}${range}${otherwise} (${row.formats.join(', ')})`] as const;
  });
  return rows.map(([flag, help]) => `  ${flag}\n      ${help}`).join('\n');
}
