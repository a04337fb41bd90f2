import type { DataTexture } from 'three';
import { growthImage } from '../core/look/bark-growth.ts';
import type { BarkImage } from '../core/look/bark-image.ts';
import type { BarkLook } from '../core/species/species.ts';
import { tileTexture } from './tile-texture.ts';
import type { TreeKit } from './tree-kit.ts';

/** Texels a side of a tile of bark: some two millimetres each. */
export const BARK_SIZE = 512;
const GROWTH_SIZE = 256;

const images = new Map<BarkLook['kind'], BarkImage>();

/** The textures in use, and by how many: a forest has one of each kind. */
const shared = new Map<string, { texture: DataTexture; users: number }>();

function share(name: string, make: () => DataTexture): DataTexture {
  let entry = shared.get(name);
  if (!entry) {
    entry = { texture: make(), users: 0 };
    entry.texture.name = name;
    shared.set(name, entry);
  }
  entry.users++;
  return entry.texture;
}

/** Gives back a texture of this file; the last to do so frees it. */
export function releaseBark(texture: DataTexture): void {
  const entry = shared.get(texture.name);
  if (entry?.texture !== texture || --entry.users > 0) return;
  shared.delete(texture.name);
  texture.dispose();
}

/** The bark of a kind as a texture that tiles; the image is made once a page. Give it back with `releaseBark`. */
export const barkTexture = (kind: BarkLook['kind'], kit: Pick<TreeKit, 'barkImage'>): DataTexture =>
  share(`bark ${kind}`, () => makeBark(kind, kit));

function makeBark(kind: BarkLook['kind'], kit: Pick<TreeKit, 'barkImage'>): DataTexture {
  let image = images.get(kind);
  if (!image) {
    image = kit.barkImage(kind, BARK_SIZE);
    images.set(kind, image);
  }
  const texture = tileTexture(image.data, BARK_SIZE);
  texture.anisotropy = 4;
  return texture;
}

let growth: Uint8Array<ArrayBuffer> | null = null;

/** What comes over bark of any kind, as a texture that tiles. Give it back with `releaseBark`. */
export const growthTexture = (): DataTexture =>
  share('bark growth', () => {
    growth ??= growthImage(GROWTH_SIZE);
    return tileTexture(growth, GROWTH_SIZE);
  });
