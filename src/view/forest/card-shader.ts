import fragment from '../../../shaders/forest/card-fragment.glsl';
import read from '../../../shaders/forest/card-read.glsl';
import vertex from '../../../shaders/forest/card-vertex.glsl';
import softCut from '../../../shaders/forest/soft-cut.glsl';
import crown from '../../../shaders/leaf/crown.glsl';
import through from '../../../shaders/leaf/through.glsl';
import { layoutGlsl } from '../../core/pack/layout-glsl.ts';
import type { Injection, Patch } from '../inject.ts';
import { SHADOW_TOWARDS_SUN } from '../leaf-shader.ts';
import { MIRRORS_NOTHING, oneLook } from '../lean-light.ts';
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
      before: `${crown}
uniform float cardThin;
uniform float cardMeanForce;
flat out mat3 vCardFacing;
out vec4 vCardCrown;
out float vCardLaid;`,
    },
    {
      anchor: '#include <beginnormal_vertex>',
      instead: `vec3 objectNormal = here.facing[2];
vCardLaid = cardThin * crownLaid(here.force, cardMeanForce);
vCardFacing = mat3(modelViewMatrix) * here.facing;
vCardCrown = vec4(normalize(mat3(modelViewMatrix) * crownNormal(here.position)), crownSky(mix(here.centre, here.position, 0.8)));`,
    },
    SHADOW_TOWARDS_SUN,
  ],
  fragment: [
    ...GROVE_FRAGMENT,
    { anchor: '#include <common>', after: fragment },
    {
      anchor: '#include <lights_physical_pars_fragment>',
      after: `#define LEAF_THROUGH (cardThrough * vCardCrown.w)\n${through}`,
    },
    MIRRORS_NOTHING,
    oneLook('1'),
    {
      anchor: '#include <map_fragment>',
      after:
        'vec4 clump = cardColour();\ndiffuseColor *= vec4(mix(laidColour(clump.rgb, vCardLaid), levelTint.rgb, levelTint.a), clump.a);',
    },
    { anchor: '#include <alphatest_fragment>', instead: softCut },
    {
      anchor: '#include <normal_fragment_begin>',
      instead: 'vec3 normal = cardNormal();\nvec3 nonPerturbedNormal = normal;',
    },
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= vCardCrown.w;
reflectedLight.indirectSpecular *= 0.3 * vCardCrown.w;
// The normal of a picture's texel is the mean of many leaves', and too smooth: what it would mirror is kept low.
reflectedLight.directSpecular *= 0.25;`,
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
