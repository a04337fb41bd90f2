import { OWN_WIND } from '../core/link/document.ts';
import { encodeWind } from '../core/link/encode-wind.ts';
import { roundWind } from '../core/link/round-wind.ts';
import type { Wind } from '../core/wind/wind.ts';

type Pair = readonly [key: string, value: string | number];

/** What stands behind `#` in the editor's address for a wind on a tree that the first pairs name. */
export function linkOf(tree: readonly Pair[], wind: Wind): string {
  const pairs: Pair[] = [...tree, ['arrows', 1]];
  // The description is that of the wind it was made from.
  encodeWind(OWN_WIND, roundWind({ ...wind, description: '' }), (key, value) => pairs.push([key, value]));
  return pairs.map(([key, value]) => `${key}=${encodeURIComponent(value).replaceAll('%2C', ',')}`).join('&');
}

/** The same for a wind on an aspen. */
export const windLink = (wind: Wind): string =>
  linkOf(
    [
      ['s', 'quaking-aspen'],
      ['seed', 1],
    ],
    wind,
  );
