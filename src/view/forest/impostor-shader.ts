import dither from '../../../shaders/forest/dither.glsl';
import fragment from '../../../shaders/forest/impostor-fragment.glsl';
import light from '../../../shaders/forest/impostor-light.glsl';
import read from '../../../shaders/forest/impostor-read.glsl';
import vertex from '../../../shaders/forest/impostor-vertex.glsl';
import type { Injection, Patch } from '../inject.ts';
import { MIRRORS_NOTHING, oneLook } from '../lean-light.ts';

const shape: readonly Patch[] = [
  { anchor: '#include <common>', after: vertex },
  { anchor: '#include <uv_vertex>', before: 'FarVertex here = farVertex();' },
  {
    anchor: '#include <begin_vertex>',
    instead: 'vec3 transformed = here.position;',
  },
];

/** What a class of trees does not draw of one that fades is left out, of its shadow too. */
const fade = 'if (fadedOut(vShare.x, vShare.y)) discard;';

/** For MeshStandardMaterial. */
export const IMPOSTOR_STANDARD: Injection = {
  vertex: [
    ...shape,
    {
      anchor: '#include <uv_pars_vertex>',
      before: `out vec3 vCorner;
out float vLaid;
flat out vec3 vToEye;
flat out mat3 vTreeView;
flat out vec4 vHalf;
flat out vec4 vThrough;`,
    },
    {
      anchor: '#include <beginnormal_vertex>',
      instead: `vec3 objectNormal = farTurned(here.turn, here.eye);
vCorner = here.corner;
vToEye = here.eye;
vTreeView = mat3(modelViewMatrix) * mat3(here.turn.x, here.turn.y, 0.0, -here.turn.y, here.turn.x, 0.0, 0.0, 0.0, 1.0);
vec4 farMiddle = farFact(here.layer, 0);
vec4 farSize = farFact(here.layer, 1);
vHalf = vec4(farMiddle.w, farSize.x, farFact(here.layer, 2).w - farMiddle.z, farSize.w);
vThrough = farFact(here.layer, 4);
vLaid = here.laid * vThrough.w;`,
    },
    {
      // The quad that the light sees stands through the middle of the tree: a tree would shade its own far side, which its own picture does
      // already. Its shadow is looked up before it, where only others' fall.
      anchor: '#include <shadowmap_vertex>',
      before: `#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  mat4 toShadow = directionalShadowMatrix[0];
  vec3 toLight = -normalize(vec3(toShadow[0].z, toShadow[1].z, toShadow[2].z));
  vec3 farRadii = farFact(here.layer, 3).xyz;
  worldPosition.xyz += toLight * (1.1 * farPlace.w * max(farRadii.x, max(farRadii.y, farRadii.z)));
#endif`,
    },
  ],
  fragment: [
    { anchor: '#include <common>', after: `${fragment}\nflat in vec2 vShare;\n${dither}` },
    { anchor: '#include <lights_physical_pars_fragment>', after: light },
    MIRRORS_NOTHING,
    oneLook('1'),
    { anchor: '#include <clipping_planes_fragment>', after: fade },
    {
      anchor: '#include <map_fragment>',
      after: 'diffuseColor.rgb *= farDiffuse();\ndiffuseColor.a = farAlpha;',
    },
    {
      anchor: '#include <normal_fragment_begin>',
      instead: 'vec3 normal = farNormal;\nvec3 nonPerturbedNormal = normal;',
    },
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= farSky;
reflectedLight.indirectSpecular *= 0.3 * farSky;`,
    },
  ],
};

/** For MeshDepthMaterial and MeshDistanceMaterial: the nearest view is enough. */
export const IMPOSTOR_DEPTH: Injection = {
  vertex: shape,
  fragment: [
    { anchor: '#include <common>', after: `${read}\nflat in vec2 vShare;\n${dither}` },
    {
      anchor: '#include <map_fragment>',
      after: `${fade}
diffuseColor.a = farColour(vViewsAB.xy, vCellsAB.xy).a;`,
    },
  ],
};
