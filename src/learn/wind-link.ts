import { OWN_WIND } from '../core/link/document.ts';
import { encodeWind } from '../core/link/encode-wind.ts';
import { roundWind } from '../core/link/round-wind.ts';
import type { Wind } from '../core/wind/wind.ts';

/** What stands behind `#` in the editor's address for a wind on a tree. */
export function windLink(wind: Wind, species = 'quaking-aspen'): string {
  const pairs: [string, string | number][] = [
    ['s', species],
    ['seed', 1],
    ['arrows', 1],
  ];
  // The description is that of the wind it was made from.
  encodeWind(OWN_WIND, roundWind({ ...wind, description: '' }), (key, value) => pairs.push([key, value]));
  return pairs.map(([key, value]) => `${key}=${encodeURIComponent(value).replaceAll('%2C', ',')}`).join('&');
}
