import type { Patch } from '../inject.ts';

/** What a class of trees does not draw of one that fades is left out, of its shadow too; a grove brings both (grove.ts), a tree that stands alone has neither. */
export const GROVE_FRAGMENT: readonly Patch[] = [
  { anchor: '#include <common>', after: '#pragma grove_shares' },
  { anchor: '#include <clipping_planes_fragment>', after: '#pragma grove_fade' },
];
