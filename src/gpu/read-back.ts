import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { TEXEL } from '../core/pack/layout.ts';

/** Texels of a target: x, y of the lowest, width, height. */
export type TexelWindow = readonly [x: number, y: number, width: number, height: number];

/**
 * The numbers of textures number 0 to `layers` - 1 of a float target, one after the other, without waiting for the GPU: they are as of
 * now, and are there some frames later. null where the context was lost meanwhile.
 *
 * The GPU copies into a buffer of its own, and a fence says when that is done (WebGL 2.0, PIXEL_PACK_BUFFER).
 */
export async function readBack(
  renderer: WebGLRenderer,
  target: WebGLRenderTarget,
  layers: number,
  [x, y, width, height]: TexelWindow,
): Promise<Float32Array | null> {
  if (renderer.getContext().isContextLost()) return null;
  const floats = width * height * TEXEL;
  const out = new Float32Array(layers * floats);
  const one = (layer: number) => {
    const part = out.subarray(layer * floats, (layer + 1) * floats);
    // All are begun in this task, before another draw can change what they read.
    return renderer.readRenderTargetPixelsAsync(target, x, y, width, height, part, undefined, layer);
  };
  try {
    await Promise.all(Array.from({ length: layers }, (_, layer) => one(layer)));
  } catch (error) {
    if (renderer.getContext().isContextLost()) return null;
    throw error;
  }
  return out;
}
