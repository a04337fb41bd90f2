import fragment from '../../../shaders/forest/card-fragment.glsl';
import read from '../../../shaders/forest/card-read.glsl';
import through from '../../../shaders/forest/card-through.glsl';
import vertex from '../../../shaders/forest/card-vertex.glsl';
import crown from '../../../shaders/leaf/crown.glsl';
import { layoutGlsl } from '../../core/pack/layout-glsl.ts';
import type { Injection, Patch } from '../inject.ts';
import { GROVE_FRAGMENT } from './grove-shader.ts';

const shape: readonly Patch[] = [
  { anchor: '#include <common>', after: `${layoutGlsl()}\n${vertex}\nout vec4 vCard;` },
  {
    anchor: '#include <uv_vertex>',
    before: 'CardVertex here = cardVertex();\nvCard = vec4(here.corner, here.picture, here.own);',
  },
  { anchor: '#include <begin_vertex>', instead: 'vec3 transformed = here.position;' },
];

/** For MeshStandardMaterial. */
export const CARD_STANDARD: Injection = {
  vertex: [
    ...shape,
    {
      anchor: '#include <uv_pars_vertex>',
      before: `${crown}\nflat out mat3 vCardFacing;\nout vec4 vCardCrown;`,
    },
    {
      anchor: '#include <beginnormal_vertex>',
      instead: `vec3 objectNormal = here.facing[2];
vCardFacing = mat3(modelViewMatrix) * here.facing;
vCardCrown = vec4(normalize(mat3(modelViewMatrix) * crownNormal(here.position)), crownSky(here.position));`,
    },
    {
      // Shadows are looked up a little nearer to the sun, as those of leaves are.
      anchor: '#include <shadowmap_vertex>',
      before: `#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  mat4 toShadow = directionalShadowMatrix[0];
  transformedNormal = -normalize((viewMatrix * vec4(toShadow[0].z, toShadow[1].z, toShadow[2].z, 0.0)).xyz);
#endif`,
    },
  ],
  fragment: [
    ...GROVE_FRAGMENT,
    { anchor: '#include <common>', after: fragment },
    { anchor: '#include <lights_physical_pars_fragment>', after: through },
    {
      anchor: '#include <map_fragment>',
      after: 'vec4 clump = cardColour();\ndiffuseColor *= vec4(mix(clump.rgb, levelTint.rgb, levelTint.a), clump.a);',
    },
    {
      anchor: '#include <normal_fragment_begin>',
      instead: 'vec3 normal = cardNormal();\nvec3 nonPerturbedNormal = normal;',
    },
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= vCardCrown.w;
reflectedLight.indirectSpecular *= 0.3 * vCardCrown.w;`,
    },
  ],
};

/** For MeshDepthMaterial and MeshDistanceMaterial. */
export const CARD_DEPTH: Injection = {
  vertex: shape,
  fragment: [
    ...GROVE_FRAGMENT,
    { anchor: '#include <common>', after: read },
    { anchor: '#include <map_fragment>', after: 'diffuseColor.a = textureLod(cardColours, cardPlace(), cardLod()).a;' },
  ],
};
