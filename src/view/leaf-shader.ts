import { ShaderChunk } from 'three';
import leafFragment from '../../shaders/leaf/fragment.glsl';
import lit from '../../shaders/leaf/lit.glsl';
import litFragment from '../../shaders/leaf/lit-fragment.glsl';
import litVertex from '../../shaders/leaf/lit-vertex.glsl';
import leafLook from '../../shaders/leaf/look-vertex.glsl';
import leafThrough from '../../shaders/leaf/through.glsl';
import leafVertex from '../../shaders/leaf/vertex.glsl';
import { layoutGlsl } from '../core/pack/layout-glsl.ts';
import { GROVE_FRAGMENT } from './forest/grove-shader.ts';
import type { Injection, Patch } from './inject.ts';
import { MIRRORS_NOTHING, oneLook } from './lean-light.ts';

/** Where the leaf takes over from three's own vertex; every material has these. */
const shape: readonly Patch[] = [
  { anchor: '#include <common>', after: `${layoutGlsl()}\n${leafVertex}` },
  { anchor: '#include <uv_vertex>', before: 'LeafVertex here = leafVertex();' },
  { anchor: '#include <beginnormal_vertex>', instead: 'vec3 objectNormal = here.normal;' },
  {
    anchor: '#include <begin_vertex>',
    instead: `vec3 transformed = here.position;
#ifdef USE_ALPHAHASH
  vPosition = transformed;
#endif`,
  },
];

/** A leaf that shows the eye its unlit side must not shade itself: its shadow is looked up a little nearer to the sun. */
export const SHADOW_TOWARDS_SUN: Patch = {
  anchor: '#include <shadowmap_vertex>',
  before: `#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  mat4 toShadow = directionalShadowMatrix[0];
  transformedNormal = -normalize((viewMatrix * vec4(toShadow[0].z, toShadow[1].z, toShadow[2].z, 0.0)).xyz);
#endif`,
};

/** LEAF_LIT where this three tells shaders what lit.glsl asks for and keeps depths in its shadow maps; else leaves are lit pixel by pixel. */
export const LIT_AT_CORNERS: readonly string[] =
  ShaderChunk.lights_pars_begin.includes('NUM_SUN_LIGHTS') &&
  ShaderChunk.shadowmap_pars_fragment.includes('sampler2DShadow directionalShadowMap')
    ? ['LEAF_LIT']
    : [];

/** For MeshStandardMaterial and MeshPhysicalMaterial, both sides drawn. */
export const LEAF_STANDARD: Injection = {
  vertex: [
    ...shape,
    { anchor: '#include <uv_pars_vertex>', before: `${lit}\n${leafLook}\n#pragma channel_vertex` },
    {
      anchor: '#include <defaultnormal_vertex>',
      after: `transformedNormal = leafShadingNormal(
  normalize(transformedNormal),
  (modelViewMatrix * vec4(here.position, 1.0)).xyz,
  normalize(normalMatrix * crownNormal(here.position)),
  projectionMatrix[2][3] == 0.0
);
vLeaf = vec4(blade.w, crownSky(here.position), blade.xy);
leafColours(here.own);
#pragma channel_leaf`,
    },
    SHADOW_TOWARDS_SUN,
    { anchor: '#include <clipping_planes_pars_vertex>', before: litVertex },
    {
      anchor: '#include <fog_vertex>',
      before: `#ifdef LEAF_AT_CORNERS
lightLeaf(vNormal, mvPosition.xyz, dot(normalMatrix * here.normal, isOrthographic ? vec3(0.0, 0.0, 1.0) : -mvPosition.xyz) >= 0.0);
#endif`,
    },
  ],
  fragment: [
    ...GROVE_FRAGMENT,
    { anchor: '#include <common>', after: `${leafFragment}\n#pragma channel_fragment` },
    { anchor: '#include <lights_physical_pars_fragment>', after: leafThrough },
    { anchor: '#include <bumpmap_pars_fragment>', before: litFragment },
    MIRRORS_NOTHING,
    // Crowns are deep, and a leaf some way off is smaller than the edge of its shadow.
    oneLook('1'),
    {
      anchor: '#include <map_fragment>',
      after: `#if !defined(LEAF_AT_CORNERS) || defined(LEAF_NEAR)
diffuseColor.rgb *= leafDiffuse(gl_FrontFacing);
#endif
#pragma channel_diffuse`,
    },
    // Rasterisers in software run what is of no use as well: it is not compiled.
    { anchor: '#include <roughnessmap_fragment>', before: '#ifndef LEAF_AT_CORNERS' },
    // The vertex has turned the normal to the eye already; three turns it by the side of the triangle.
    {
      anchor: '#include <normal_fragment_begin>',
      after: `#ifdef DOUBLE_SIDED
  normal *= faceDirection;
#endif`,
    },
    // Rounded normals lie aslant to the eye along the crown's rim: what they would mirror of the sky is kept low.
    {
      anchor: '#include <aomap_fragment>',
      after: `reflectedLight.indirectDiffuse *= vLeaf.y;
reflectedLight.indirectSpecular *= 0.3 * vLeaf.y;
#else
reflectedLight.directDiffuse = leafLit(diffuseColor.rgb);
#endif`,
    },
  ],
};

/** For MeshDepthMaterial and MeshDistanceMaterial. */
export const LEAF_DEPTH: Injection = { vertex: shape, fragment: GROVE_FRAGMENT };
