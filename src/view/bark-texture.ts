import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  RGBAFormat,
  UnsignedByteType,
} from 'three';
import type { BarkLook } from '../core/species/species.ts';
import { type BarkImage, barkImage } from './bark-image.ts';

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
  const texture = new DataTexture(image.data, SIZE, SIZE, RGBAFormat, UnsignedByteType);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.name = `bark ${kind}`;
  texture.needsUpdate = true;
  return texture;
}
