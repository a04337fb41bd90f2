import { ShaderChunk } from 'three';
import type { Patch } from './inject.ts';

/** Three works out what a surface mirrors of an environment where there is none too; that is nothing. */
export const MIRRORS_NOTHING: Patch = {
  anchor: '#include <lights_fragment_begin>',
  before: `#ifndef USE_ENVMAP
#undef RE_IndirectSpecular
#endif`,
};

/** The sum of five looks at a shadow map that three takes for a soft edge; sines turn them by the pixel. */
const FIVE = /shadow = \(\s*texture\( shadowMap, vec3\([^;]*vogelDiskSample\( 4,[^;]*\) \* 0\.2;/;

/** Three's lookup of shadows, with one filtered look at those of suns and spots where `when` is defined; as it is where three is another. */
export const oneLook = (when: string): Patch => ({
  anchor: '#include <shadowmap_pars_fragment>',
  instead: ShaderChunk.shadowmap_pars_fragment.replace(
    FIVE,
    (five) => `
#if ${when}
shadow = texture(shadowMap, shadowCoord.xyz);
#else
${five}
#endif
`,
  ),
});
