import type { LinkReader } from '../link/reader.ts';
import { allowed, readNumber } from '../link/rule.ts';
import type { ForestSpecies, Habitat, HabitatRange } from './forest.ts';
import { HABITAT_NUMBERS, MOST_SPECIES, SHARE } from './forest-numbers.ts';

const LETTERS = { altitude: 'a', slope: 's', wetness: 'w' } as const;
type Part = keyof typeof LETTERS;
const PARTS = Object.keys(LETTERS) as Part[];

/** `silver-birch:0.4:a20_90_10:w0_0.5_0.1,scots-pine:0.6`: a share, then ranges of altitude, slope, wetness as least, most, soft. */
export const encodeMix = (mix: readonly ForestSpecies[]): string =>
  mix
    .map(({ species, share, where = {} }) =>
      [species, share, ...PARTS.flatMap((part) => (where[part] ? [rangeText(part, where[part])] : []))].join(':'),
    )
    .join();

const rangeText = (part: Part, { least, most, soft }: HabitatRange): string =>
  `${LETTERS[part]}${least}_${most}_${soft}`;

/** What `encodeMix` wrote; the fallback and a fault where a part of it is wrong. */
export function decodeMix(
  reader: LinkReader,
  fallback: readonly ForestSpecies[],
  known: readonly string[],
): readonly ForestSpecies[] {
  const text = reader.take('mix');
  if (text === undefined) return fallback;
  const entries = text.split(',');
  const bad = (found: string, words: string): readonly ForestSpecies[] => {
    reader.fault('mix', found, words);
    return fallback;
  };
  if (entries.length > MOST_SPECIES) return bad(`${entries.length} species`, `1 to ${MOST_SPECIES} species`);
  const mix: ForestSpecies[] = [];
  for (const entry of entries) {
    const [species = '', share = '', ...ranges] = entry.split(':');
    const part = readNumber(SHARE, share);
    if (!known.includes(species)) return bad(species, `species that ship: ${known.join(', ')}`);
    if (mix.some((other) => other.species === species)) return bad(species, 'each species once');
    if (part === undefined) return bad(entry, `after the species ${allowed(SHARE)}`);
    const where = habitatOf(ranges);
    if (!where) return bad(entry, 'a, s or w for altitude, slope or wetness, then least_most_soft');
    mix.push({ species, share: part, ...(ranges.length > 0 && { where }) });
  }
  return mix.some(({ share }) => share > 0) ? mix : bad(text, 'at least one share above 0');
}

function habitatOf(ranges: readonly string[]): Habitat | undefined {
  const where: { -readonly [Key in keyof Habitat]: Habitat[Key] } = {};
  for (const text of ranges) {
    const part = PARTS.find((each) => LETTERS[each] === text[0]);
    if (!part || where[part]) return undefined;
    const rule = HABITAT_NUMBERS[part];
    const numbers = text.slice(1).split('_');
    const [least, most, soft] = [rule, rule, { ...rule, min: 0 }].map((each, i) => readNumber(each, numbers[i] ?? ''));
    if (numbers.length !== 3 || least === undefined || most === undefined || soft === undefined || most < least)
      return undefined;
    where[part] = { least, most, soft };
  }
  return where;
}
