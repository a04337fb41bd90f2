import type { DataTexture } from 'three';
import { type BarkImage, barkImage } from '../core/look/bark-image.ts';
import type { BarkLook } from '../core/species/species.ts';
import { tileTexture } from './tile-texture.ts';

/** Texels a side: two millimetres of bark each. */
const SIZE = 512;

const images = new Map<BarkLook['kind'], BarkImage>();

/** The bark of a kind as a texture that tiles. The image is made once a page, the texture belongs to the caller. */
export function barkTexture(kind: BarkLook['kind']): DataTexture {
  let image = images.get(kind);
  if (!image) {
    image = barkImage(kind, SIZE);
    images.set(kind, image);
  }
  const texture = tileTexture(image.data, SIZE);
  texture.anisotropy = 4;
  texture.name = `bark ${kind}`;
  return texture;
}
