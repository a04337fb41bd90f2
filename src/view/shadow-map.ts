import { ShaderChunk } from 'three';

/** Names the type of a shadow map as `getShadow` takes it: three compares in the sampler from r182 on, and in the shader before. */
export const SHADOW_MAP = `#define SHADOW_MAP ${
  ShaderChunk.shadowmap_pars_fragment.includes('sampler2DShadow') ? 'sampler2DShadow' : 'sampler2D'
}`;
