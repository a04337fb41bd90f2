import { allowedValues } from './allowed.ts';
import type { Parameter, ParameterTable } from './parameter.ts';

const cell = (text: string): string => text.replaceAll('|', '\\|');

/** What a parameter is where a file leaves it out; '' where that is nothing. */
export function defaultText(p: Parameter): string {
  if (p.default === undefined) return '';
  return Array.isArray(p.default) ? p.default.join(', ') : String(p.default);
}

/** What a parameter means, in sentences. */
export function meaningOf(p: Parameter): string {
  const parts = [p.help];
  if (p.kind === 'number' && p.negative) parts.push(p.negative);
  if (p.kind === 'number' && p.orNull) parts.push(`null: ${p.orNull}.`);
  if (p.kind === 'number' && p.names) parts.push(`${p.names.map((name, id) => `${id} ${name}`).join(', ')}.`);
  if (p.levels === 'trunk') parts.push('Level 0 only.');
  if (p.levels === 'branches' && p.key !== 'branches') parts.push('Levels 1 and deeper.');
  return parts.join(' ');
}

/** A chapter of a page of docs: a part of a file, and a table of its parameters. A default stands where a file may leave one out. */
export function describeTable({ group, title, help, parameters }: ParameterTable): string[] {
  const rows = parameters.map((p) => {
    const cells = [
      `\`${p.key}\``,
      p.symbol,
      p.section,
      allowedValues(p),
      p.optional ? defaultText(p) : '',
      meaningOf(p),
    ];
    return `| ${cells.map(cell).join(' | ')} |`;
  });
  return [
    group === '' ? `## ${title}` : `## ${title}: \`${group}\``,
    '',
    help,
    '',
    '| key | paper | section | allowed | default | meaning |',
    '|---|---|---|---|---|---|',
    ...rows,
    '',
  ];
}
