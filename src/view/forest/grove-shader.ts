import dither from '../../../shaders/forest/dither.glsl';
import type { Patch } from '../inject.ts';

/** What a class of trees does not draw of one that fades is left out, of its shadow too; a tree that stands alone has none of this. */
export const GROVE_FRAGMENT: readonly Patch[] = [
  {
    anchor: '#include <common>',
    after: `#ifdef GROVE
flat in vec2 vShare;
${dither}
#endif`,
  },
  {
    anchor: '#include <clipping_planes_fragment>',
    after: `#ifdef GROVE
if (fadedOut(vShare.x, vShare.y)) discard;
#endif`,
  },
];
