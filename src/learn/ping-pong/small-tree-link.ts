import { textToBase64 } from '../../core/link/text.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { linkOf } from '../wind-link.ts';
import { SMALL_TREE_SEED, smallTreeFile } from './small-tree.ts';

/** What stands behind `#` in the editor's address for a wind on the small tree of the lessons, bare as they draw it. */
export const smallTreeLink = (wind: Wind, view = 'shaded'): string =>
  linkOf(
    [
      ['own', textToBase64(smallTreeFile())],
      ['seed', SMALL_TREE_SEED],
      ['leaves', 0],
      ['view', view],
    ],
    wind,
  );
