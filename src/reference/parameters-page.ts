import type { ParameterTable } from '../core/file/parameter.ts';
import { GROUPS } from '../core/species/parameters.ts';
import { anchorOf, contents, escaped } from './markup.ts';
import { type PicturePair, parameterEntry, pathOf } from './parameter-entry.ts';
import { words } from './words.ts';

const titleOf = (table: ParameterTable): string => anchorOf(table.title);

/** Chapters of a table of parameters, each with its heading and its entries; `pictures` by path. */
export const chapters = (tables: readonly ParameterTable[], pictures: ReadonlyMap<string, PicturePair>): string =>
  tables
    .map(
      (table) => `<section class="group" id="${titleOf(table)}"><h2>${escaped(table.title)}${
        table.group === '' ? '' : ` <code>${table.group}</code>`
      }</h2><p>${escaped(table.help)}</p>
${table.parameters.map((p) => parameterEntry(p, pictures.get(pathOf(p)))).join('\n')}</section>`,
    )
    .join('\n');

/** Names of the chapters, and a field that finds a parameter; the field shows itself when its script runs. */
export const finder = (tables: readonly ParameterTable[]): string =>
  `${contents(
    words.contents,
    tables.map((table) => [titleOf(table), table.title] as const),
  )}
<search class="finder" hidden><label>${words.find} <input type="search" placeholder="${words.findHint}" autocomplete="off" spellcheck="false"></label> <span class="soft" role="status"></span></search>`;

/** The page of the parameters of a species, from the one table of them. */
export const parametersPage = (pictures: ReadonlyMap<string, PicturePair>): string =>
  `${finder(GROUPS)}\n${chapters(GROUPS, pictures)}`;
