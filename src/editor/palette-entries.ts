import { PLACES } from '../core/species/edits.ts';
import { GROUPS } from '../core/species/parameters.ts';
import type { Editor } from './editor.ts';
import { fits, plain } from './fuzzy.ts';
import { COMMANDS, drawLevels, keysOf } from './shortcuts.ts';
import { revealParameter } from './ui/tree/reveal.ts';
import { commandWords } from './words/commands.ts';
import { pageWords } from './words/pages.ts';
import { paletteWords } from './words/palette.ts';

/** Something that the palette finds and does. */
export interface Entry {
  readonly id: string;
  readonly label: string;
  /** What it is, or its key. */
  readonly detail: string;
  /** What it is found by, `plain`. */
  readonly text: string;
  readonly run: () => void;
}

const entry = (id: string, label: string, detail: string, run: () => void, more = ''): Entry => ({
  id,
  label,
  detail,
  text: plain(`${label} ${more}`),
  run,
});

const commands = (editor: Editor): Entry[] =>
  COMMANDS.filter((c) => c.act && c.id !== 'palette' && (c.enabled?.(editor) ?? true)).map(({ id, group, act }) =>
    entry(
      `command-${id}`,
      commandWords.labels[id],
      keysOf(id)[0] ?? '',
      () => act!(editor),
      commandWords.groups[group],
    ),
  );

const levels = (editor: Editor): Entry[] =>
  commandWords.drawTo.map((label, i) =>
    entry(`levels-${i}`, label, String(i + 1), () => drawLevels(editor, i + 1), paletteWords.kinds.levels),
  );

const species = (editor: Editor): Entry[] =>
  editor.session
    .getState()
    .species.map(({ id, name, latin }) =>
      entry(
        `species-${id}`,
        paletteWords.changeTo(name),
        paletteWords.kinds.species,
        () => editor.actions.setSpecies(id),
        latin,
      ),
    );

const winds = (editor: Editor): Entry[] =>
  editor.session
    .getState()
    .winds.map(({ id, name, description }) =>
      entry(
        `wind-${id}`,
        paletteWords.blow(name),
        paletteWords.kinds.wind,
        () => editor.actions.setPreset(id),
        description,
      ),
    );

const pages = (): Entry[] =>
  pageWords.pages.map(({ id, name, about, href }) =>
    entry(`page-${id}`, pageWords.open(name), pageWords.kind, () => location.assign(href), about),
  );

const titles = new Map<string, string>(GROUPS.map(({ group, title }) => [group, title]));

/** Every setting of the tree: `Down angle of limbs`. */
const settings = (editor: Editor): Entry[] =>
  [...PLACES.values()].map(({ path, parameter, level }) => {
    const { label, symbol, group } = parameter;
    const of = level === undefined ? (titles.get(group) ?? '') : paletteWords.stems[level]!;
    const name = level === undefined ? label : `${label} ${of}`;
    const detail = level === undefined ? of : paletteWords.kinds.setting;
    return entry(`set-${path}`, name, detail, () => void revealParameter(editor, path), `${symbol} ${of} ${path}`);
  });

/** All that can be done or set now. */
export const paletteEntries = (editor: Editor): Entry[] => [
  ...commands(editor),
  ...levels(editor),
  ...species(editor),
  ...winds(editor),
  ...settings(editor),
  ...pages(),
];

/** Those that fit a query, best first; all of them, in their order, where it asks nothing. */
export function findEntries(entries: readonly Entry[], query: string): readonly Entry[] {
  const asked = plain(query);
  if (asked === '') return entries;
  return entries
    .map((each) => ({ each, worth: fits(asked, each.text) + (fits(asked, plain(each.label)) > 0 ? 3 : 0) }))
    .filter(({ worth }) => worth >= 1)
    .sort((a, b) => b.worth - a.worth)
    .map(({ each }) => each);
}
