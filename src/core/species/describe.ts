import { allowedValues } from './allowed.ts';
import type { Parameter } from './parameter.ts';
import { GROUPS } from './parameters.ts';

const cell = (text: string): string => text.replaceAll('|', '\\|');

function value(p: Parameter): string {
  if (p.default === undefined) return '';
  return Array.isArray(p.default) ? p.default.join(', ') : String(p.default);
}

function notes(p: Parameter): string {
  const parts = [p.help];
  if (p.kind === 'number' && p.negative) parts.push(p.negative);
  if (p.kind === 'number' && p.names) parts.push(`${p.names.map((name, id) => `${id} ${name}`).join(', ')}.`);
  if (p.levels === 'trunk') parts.push('Level 0 only.');
  if (p.levels === 'branches' && p.key !== 'branches') parts.push('Levels 1 and deeper.');
  return parts.join(' ');
}

/** The page docs/parameters.md, made from the parameter table. */
export function describeParameters(): string {
  const lines = [
    '# Parameters of a species',
    '',
    'Made from the parameter table in `src/core/species`; do not edit by hand. Symbols and sections are those of Weber & Penn, "Creation and',
    'Rendering of Realistic Trees", 1995. Parameters without a symbol are Windgrove\'s own; a file may leave them out and gets the default.',
    'A species file also has `format` ("windgrove-species"), `version` (1), `name`, `latin` and `source`.',
    '',
  ];
  for (const group of GROUPS) {
    lines.push(`## ${group.title}: \`${group.group}\``, '', group.help, '');
    lines.push('| key | paper | section | allowed | default | meaning |', '|---|---|---|---|---|---|');
    for (const p of group.parameters) {
      const cells = [`\`${p.key}\``, p.symbol, p.section, allowedValues(p), p.symbol ? '' : value(p), notes(p)];
      lines.push(`| ${cells.map(cell).join(' | ')} |`);
    }
    lines.push('');
  }
  return `${lines.join('\n').trimEnd()}\n`;
}
