import { PLACES } from '../../../core/species/edits.ts';
import { GROUPS } from '../../../core/species/parameters.ts';
import { treeWords } from '../../words/tree.ts';

/** Letters alone, small: 'n-Down Angle' is found by 'ndownangle' and by 'down angle'. */
const plain = (text: string): string =>
  text
    .toLowerCase()
    .normalize('NFKD')
    .replace(/[^a-z0-9]+/g, ' ')
    .trim();

/** What each path is found by. */
const TEXTS: ReadonlyMap<string, string> = new Map(
  [...PLACES].map(([path, { parameter, level }]) => {
    const { label, help, symbol, group } = parameter;
    const name = level === undefined ? '' : treeWords.levels[level]!;
    const more = parameter.kind === 'number' ? `${parameter.negative ?? ''} ${(parameter.names ?? []).join(' ')}` : '';
    const title = GROUPS.find((g) => g.group === group)!.title;
    const words = [label, help, symbol, name, title, more, path].map(plain).join(' ');
    // Without spaces, too: the path of level 1 then holds the paper's 1DownAngle.
    return [path, ` ${words} ${words.replaceAll(' ', '')}`];
  }),
);

/** Whether a parameter is meant by a search: each of its words begins a word of the label, help, symbol, level or path. */
export function isFound(path: string, query: string): boolean {
  const text = TEXTS.get(path) ?? '';
  const words = plain(query).split(' ').filter(Boolean);
  return words.every((word) => text.includes(` ${word}`) || (word.length > 3 && text.includes(word)));
}

/** All paths that a search means, those first whose label or symbol begins with it. */
export function findPlaces(query: string): readonly string[] {
  const asked = plain(query);
  const first = (path: string): number => {
    const { label, symbol } = PLACES.get(path)!.parameter;
    return plain(label).startsWith(asked) || plain(symbol).replace(/^n/, '').startsWith(asked) ? 0 : 1;
  };
  return [...PLACES.keys()].filter((path) => isFound(path, query)).sort((a, b) => first(a) - first(b));
}
