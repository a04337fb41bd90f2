import { Color, type Vector4 } from 'three';
import { twigColour } from '../core/look/bark-colour.ts';
import { barkWrap } from '../core/look/bark-wrap.ts';
import type { BarkLook, Species } from '../core/species/species.ts';
import { BARK_SIZE, barkTexture, growthTexture, releaseBark } from './bark-texture.ts';
import type { TreeKit } from './tree-kit.ts';
import type { BarkUniforms } from './uniforms.ts';

/** How the stems of a level are drawn: near by with the relief of their bark in the surface, as tubes, or as ribbons that face the eye. */
export type StemForm = 'deep' | 'tube' | 'ribbon';

/** Levels whose bark is old enough to bear clouds, moss and ridges. */
const OLD_LEVELS = 2;

/** What a kind of bark is besides its tile, at any level or at the foot alone (shaders/branch/bark-own.glsl). */
const OWN: Partial<Record<BarkLook['kind'], string>> = {
  peeling: 'BARK_FOOT',
  ribbed: 'BARK_SPINED',
  noded: 'BARK_BLOOM',
};

/** Does a bark's program need bark-own.ts? */
export const hasOwn = (kind: BarkLook['kind']): boolean => OWN[kind] !== undefined;

/** The parts of the bark's programs that a level needs; each that is left out saves work. */
export function barkDefines(level: number, { bark }: Species, form: StemForm): string[] {
  if (form === 'ribbon') return [];
  const old = level < OLD_LEVELS;
  const own = OWN[bark.kind];
  return [
    level > 0 ? 'JOINED' : '',
    old ? 'BARK_OLD' : '',
    old && (bark.moss > 0 || bark.lichen > 0) ? 'BARK_GROWTH' : '',
    own && (level === 0 || bark.kind !== 'peeling') ? own : '',
    old && (bark.kind === 'smooth' || bark.kind === 'peeling') ? 'BARK_MARKED' : '',
    form === 'deep' ? 'BARK_DEEP' : '',
  ].filter(Boolean);
}

const between = (from: number, to: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
};

/**
 * Share of the ridges' depth, 0..1, that stands out of stems of a level where they are `pixels` thick and a metre is `scale` pixels: none where
 * it could not be seen, so that it costs nothing there, and more with every pixel, so that nothing is seen to come.
 */
export function deepShare(level: number, { depth }: BarkLook, pixels: number, scale: number): number {
  if (depth <= 0 || level >= OLD_LEVELS) return 0;
  return between(50, 110, pixels) * between(0.8, 3, depth * scale);
}

/** Mip level of the tile whose texels are as far apart as the columns of a stem. */
export function deepLod({ kind, grain }: BarkLook, radius: number, sectors: number): number {
  const texel = barkWrap({ kind, grain }).side / BARK_SIZE;
  return Math.max(0, Math.log2((2 * Math.PI * radius) / sectors / texel) - 0.6);
}

const linear = new Color();

function setColour(to: Vector4, colour: string, amount: number): void {
  linear.set(colour);
  to.set(linear.r, linear.g, linear.b, amount);
}

/** Takes the look of a bark over into the uniforms of its materials. */
export function setBarkLook(uniforms: BarkUniforms, bark: BarkLook, kit: Pick<TreeKit, 'barkImage'>): void {
  const map = uniforms.barkMap;
  if (map.value?.name !== `bark ${bark.kind}`) {
    if (map.value) releaseBark(map.value);
    map.value = barkTexture(bark.kind, kit);
  }
  uniforms.barkGrowth.value ??= growthTexture();
  const { side, steady, ribs } = barkWrap(bark);
  uniforms.barkTile.value.set(side, steady ? 1 : 0, ribs, BARK_SIZE);
  uniforms.barkColour.value.set(bark.colour);
  uniforms.barkDark.value.set(bark.dark);
  uniforms.barkTwig.value.setRGB(...twigColour(bark));
  uniforms.barkYoung.value = bark.youngRadius;
  uniforms.barkRelief.value = bark.relief;
  setColour(uniforms.barkMoss.value, bark.mossColour, bark.moss);
  setColour(uniforms.barkLichen.value, bark.lichenColour, bark.lichen);
}

/** Frees the textures; a look that is set afterwards makes them anew. */
export function disposeBarkLook({ barkMap, barkGrowth }: BarkUniforms): void {
  for (const map of [barkMap, barkGrowth]) {
    if (map.value) releaseBark(map.value);
    map.value = null;
  }
}
