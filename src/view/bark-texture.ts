import type { DataTexture } from 'three';
import { growthImage } from '../core/look/bark-growth.ts';
import { type BarkImage, barkImage } from '../core/look/bark-image.ts';
import type { BarkLook } from '../core/species/species.ts';
import { tileTexture } from './tile-texture.ts';

/** Texels a side of a tile of bark: some two millimetres each. */
export const BARK_SIZE = 512;
const GROWTH_SIZE = 256;

const images = new Map<BarkLook['kind'], BarkImage>();

/** The bark of a kind as a texture that tiles. The image is made once a page, the texture belongs to the caller. */
export function barkTexture(kind: BarkLook['kind']): DataTexture {
  let image = images.get(kind);
  if (!image) {
    image = barkImage(kind, BARK_SIZE);
    images.set(kind, image);
  }
  const texture = tileTexture(image.data, BARK_SIZE);
  texture.anisotropy = 4;
  texture.name = `bark ${kind}`;
  return texture;
}

let growth: Uint8Array<ArrayBuffer> | null = null;

/** What comes over bark of any kind, as a texture that tiles; it belongs to the caller. */
export function growthTexture(): DataTexture {
  growth ??= growthImage(GROWTH_SIZE);
  const texture = tileTexture(growth, GROWTH_SIZE);
  texture.name = 'bark growth';
  return texture;
}
