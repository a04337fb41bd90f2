/** What the colours of a figure mean; the same in text, formula and picture. */
export const COLOUR_NAMES = [
  'force',
  'answer',
  'velocity',
  'rest',
  'wrong',
  'ink',
  'soft',
  'line',
  'hairline',
  'paper',
  'well',
  'level0',
  'level1',
  'level2',
  'level3',
] as const;
export type ColourName = (typeof COLOUR_NAMES)[number];
export type Colours = Record<ColourName, string>;

const PROPERTIES: Partial<Record<ColourName, string>> = {
  // The blue of text: figures write in it, too.
  force: '--link',
  soft: '--ink-soft',
  well: '--paper-well',
  level0: '--level-0',
  level1: '--level-1',
  level2: '--level-2',
  level3: '--level-3',
};

/** The page's colours as CSS, in the theme that holds now. */
export function pageColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    COLOUR_NAMES.map((name) => [name, style.getPropertyValue(PROPERTIES[name] ?? `--${name}`).trim()]),
  ) as Colours;
}
