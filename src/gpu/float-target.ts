import { FloatType, NearestFilter, RGBAFormat, WebGLRenderTarget } from 'three';

/** RGBA32F textures of the same size, one for each of `names`, that one draw writes; empty until it does. */
export function floatTarget(width: number, height: number, names: readonly string[]): WebGLRenderTarget {
  const target = new WebGLRenderTarget(width, height, {
    count: names.length,
    format: RGBAFormat,
    type: FloatType,
    minFilter: NearestFilter, // float textures without OES_texture_float_linear sample as 0 under a linear filter
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: false,
  });
  target.textures.forEach((texture, i) => {
    texture.name = names[i];
  });
  return target;
}
