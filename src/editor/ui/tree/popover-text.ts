import { allowedValues } from '../../../core/file/allowed.ts';
import { PLACES } from '../../../core/species/edits.ts';
import { treeWords } from '../../words/tree.ts';

/** What a parameter may be: 'Allowed: a number from 0 to 360 degrees.' Ids are told by name. */
export function allowedText(path: string): string {
  const { parameter } = PLACES.get(path)!;
  const names = parameter.kind === 'number' ? parameter.names : undefined;
  return treeWords.help.allowed(names ? names.join(', ') : allowedValues(parameter));
}

/** Where a parameter comes from: 'nDownAngle, Weber & Penn 1995, 4.3'; of level 1: '1DownAngle'. */
export function sourceText(path: string): string {
  const { parameter, level } = PLACES.get(path)!;
  const { symbol, section } = parameter;
  if (!symbol && !section) return treeWords.help.ours;
  return treeWords.help.source(level === undefined ? symbol : symbol.replace(/^n/, String(level)), section);
}
