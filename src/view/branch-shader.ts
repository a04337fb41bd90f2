import barkDepth from '../../shaders/branch/bark-depth.glsl';
import barkFragment from '../../shaders/branch/bark-fragment.glsl';
import barkVertex from '../../shaders/branch/bark-vertex.glsl';
import barkWrap from '../../shaders/branch/bark-wrap.glsl';
import branchVertex from '../../shaders/branch/vertex.glsl';
import crown from '../../shaders/leaf/crown.glsl';
import { layoutGlsl } from '../core/pack/layout-glsl.ts';
import { GROVE_FRAGMENT } from './forest/grove-shader.ts';
import type { Injection, Patch } from './inject.ts';
import { MIRRORS_NOTHING } from './lean-light.ts';

/** Where the deformer takes over from three's own vertex; every material has these. */
const shape: readonly Patch[] = [
  {
    anchor: '#include <common>',
    after: `${layoutGlsl()}
${branchVertex}
${barkWrap}
#ifdef BARK_DEEP
${barkDepth}
#endif`,
  },
  {
    anchor: '#include <uv_vertex>',
    before: `BranchVertex here = branchVertex();
#ifdef BARK_DEEP
here.surface.position += here.surface.normal * barkRise(here, normal.x);
#endif`,
  },
  {
    anchor: '#include <beginnormal_vertex>',
    instead: `vec3 objectNormal = here.surface.normal;
#ifdef USE_TANGENT
  vec3 objectTangent = here.surface.around;
#endif`,
  },
  {
    anchor: '#include <begin_vertex>',
    instead: `vec3 transformed = here.surface.position;
#ifdef USE_ALPHAHASH
  vPosition = transformed;
#endif`,
  },
];

/** For MeshStandardMaterial and MeshPhysicalMaterial. */
export const BRANCH_STANDARD: Injection = {
  vertex: [
    ...shape,
    { anchor: '#include <uv_pars_vertex>', before: `${crown}\n${barkVertex}\n#pragma channel_vertex` },
    // Wood shows where the crown is open, so it is less sheltered than the leaves around it.
    {
      anchor: '#include <defaultnormal_vertex>',
      after: `vAround = (modelViewMatrix * vec4(here.surface.around, 0.0)).xyz;
barkVertex(here, normal.x, mix(1.0, crownSky(here.surface.position), 0.6));
#pragma channel_branch`,
    },
  ],
  fragment: [
    ...GROVE_FRAGMENT,
    { anchor: '#include <common>', after: `${barkFragment}\n#pragma channel_fragment` },
    { anchor: '#include <map_fragment>', after: `diffuseColor.rgb *= barkDiffuse();\n#pragma channel_diffuse` },
    { anchor: '#include <roughnessmap_fragment>', after: 'roughnessFactor = barkRoughness(roughnessFactor);' },
    { anchor: '#include <normal_fragment_maps>', after: 'normal = barkNormal(normal);' },
    MIRRORS_NOTHING,
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= barkAmbient();
reflectedLight.indirectSpecular *= barkAmbient();`,
    },
  ],
};

/** For MeshDepthMaterial and MeshDistanceMaterial: the same shape, so shadows sway too. */
export const BRANCH_DEPTH: Injection = { vertex: shape, fragment: GROVE_FRAGMENT };
