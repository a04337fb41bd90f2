import type { TableRow } from '../core/lod/table-2.ts';
import type { Season } from '../core/species/season.ts';
import type { Way } from './state.ts';

const whole = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

/** A whole number, its thousands apart. */
export const count = (n: number): string => whole.format(n);

/** How far ours is from the printed one, with its sign; nothing where both are the same. */
export function difference(ours: number, printed: number): string {
  if (ours === printed) return '0';
  const off = ours - printed;
  const sign = off > 0 ? '+' : '−';
  return printed > 0 ? `${sign}${(Math.abs(off / printed) * 100).toFixed(1)} %` : `${sign}${count(Math.abs(off))}`;
}

export const metres = (range: number): string => `${count(range)} m`;

export const rangeWords = {
  title: 'Degradation at range',
  intro:
    'In 1995 Jason Weber and Joseph Penn drew whole forests by looking less closely at the trees far away: the farther a tree, the more of its stems became lines and of its leaves points, and the fewer of those were left. The stored tree never changed; only the loops over it ran shorter. Here their rules run on the GPU, on our own quaking aspen, in the wind.',
  picture: 'A quaking aspen in the wind',
  inset: 'The tree magnified',
  loading: 'Growing the aspen …',
  failed: (why: string) => `The tree could not be drawn: ${why}`,
  linkFaults: 'Part of the link could not be read; the rest holds.',
  fault: (key: string, found: string, allowed: string) => `${key}: found “${found}”; allowed: ${allowed}.`,
  dismiss: 'Close the message',
  range: 'Range',
  way: 'Drawn by',
  ways: { paper: 'the paper', screen: 'the screen', full: 'all of it' } satisfies Record<Way, string>,
  near: 'Come near',
  nearHint: 'what is left stays as it is from afar',
  quality: 'Quality',
  season: 'Season',
  seasons: { spring: 'spring', summer: 'summer', autumn: 'autumn', winter: 'winter' } satisfies Record<Season, string>,
  wind: 'Wind',
  dark: 'Dark',
  now: 'In the picture',
  triangles: 'triangles',
  lines: 'lines',
  points: 'points',
  ms: 'ms a frame',
  r2: (r2: number) => `calibrated range r₂ = ${count(r2)}`,
  notPaper: 'the rules of the paper are off',
  table: 'Table 2, printed and drawn',
  tableLead:
    'Elements drawn on a quaking aspen in summer. Large: what this page drew when it was opened, counted from its draws. Small: what the paper prints, and how far ours is off where it is. Choose a range to see it.',
  tableLabel: 'Table 2 of the paper beside our counts; scrolls sideways where it does not fit',
  rows: {
    trunkTriangles: 'Trunk, triangles',
    trunkLines: 'Trunk, lines',
    mainTriangles: 'Main branches, triangles',
    mainLines: 'Main branches, lines',
    otherTriangles: 'Other branches, triangles',
    otherLines: 'Other branches, lines',
    leafTriangles: 'Leaves, triangles',
    leafPoints: 'Leaves, points',
  } satisfies Record<TableRow, string>,
  item: 'Item',
  fits: 'What the table fits with',
  fit: [
    'A picture 1000 rows high that spans 60 degrees: then the calibrated range is the range itself. Quality 1 in summer, so the scale of the stems is a half and that of the leaves 200.',
    'An aspen whose main branches are counted over the whole trunk, those of its bare part left out: 30 grow, not 50. The printed numbers then mean 739 lesser branches and 13 312 leaves; our tree has its own dice and grows a few fewer of the one and a few more of the other.',
    'A trunk of 36 rings of 40 triangles. Eight lines to every other stem, or four bands of four sides (main branches) and of three (the rest). Four triangles to a leaf.',
    'At the far end one point for every eight leaves, though the text says masses of four.',
    'Where the printed 760 triangles of the trunk at 600 m come from we do not know: the printed rule gives half of 1440, and so do we.',
  ],
  ours: 'What is ours',
  own: [
    'Masses are gone: stems and leaves are stored in an order of which any first part is spread evenly over the tree, so a frame draws the first so many. The last of them is drawn as far as the fraction says.',
    'Three printed jumps are bridged over a little more range: the lines of the trunk at 100 m, its last surfaces at 800 m, the surfaces of the main branches at 100 m. None touches a range of the table.',
    'A point is as large as its leaf would be, and grows where leaves are left out. Below a pixel it is left out by chance, and a line thins by a dither, so that a far crown is no denser than a near one.',
  ],
};
