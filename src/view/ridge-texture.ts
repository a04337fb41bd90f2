import { DataTexture, LinearFilter, RepeatWrapping } from 'three';
import { hashPcg, hashUnit } from '../core/math/hash.ts';

/** Texels around the viewer: a tree of a forest takes a few of them. */
const WIDTH = 4096;

/** Random numbers 0..1, the same each time. */
function draws(seed: number): () => number {
  let h = seed;
  return () => {
    h = hashPcg(h);
    return hashUnit(h);
  };
}

/** Rolling hills: waves that close around the viewer, 0..1. */
function hills(seed: number, lowest: number, highest: number): Float32Array {
  const draw = draws(seed);
  const out = new Float32Array(WIDTH);
  let total = 0;
  for (let wave = lowest; wave <= highest; wave++) {
    const high = (0.4 + draw()) / wave;
    const phase = draw() * 2 * Math.PI;
    total += high;
    for (let i = 0; i < WIDTH; i++) out[i]! += high * Math.sin((2 * Math.PI * wave * i) / WIDTH + phase);
  }
  return out.map((h) => Math.min(1, Math.max(0, 0.5 + (0.95 * h) / total)));
}

/** Round crowns side by side: `count` around the viewer, `wide` texels on average, upon a floor that rises and falls. */
function crowns(seed: number, count: number, wide: number, floor: Float32Array, share: number): Float32Array {
  const draw = draws(seed);
  const out = floor.map((h) => share * h);
  for (let tree = 0; tree < count; tree++) {
    const middle = Math.floor(draw() * WIDTH);
    const half = wide * (0.5 + draw());
    // Few stand out.
    const high = 0.35 + 0.65 * draw() * draw();
    const base = share * floor[middle]!;
    const rough = 7 + 9 * draw();
    for (let x = -Math.ceil(half); x <= half; x++) {
      const at = (middle + x + WIDTH) % WIDTH;
      const r = x / half;
      const leaves = 0.05 * Math.sin(r * rough + tree) + 0.03 * Math.sin(r * rough * 2.7);
      const top = base + (1 - share) * high * (Math.sqrt(Math.max(0, 1 - r * r)) + leaves);
      out[at] = Math.max(out[at]!, Math.min(1, top));
    }
  }
  return out;
}

/** Heights of four skylines around the viewer: far hills, near hills, forest, and trees and hedges with gaps between them. */
export function ridgeTexture(): DataTexture {
  const gaps = hills(23, 3, 9).map((h) => Math.max(0, 1.6 * h - 0.55));
  const near = crowns(5, 700, 7, gaps, 0.25).map((h, i) => h * Math.min(1, 3 * gaps[i]!));
  const lines = [hills(7, 3, 17), hills(11, 5, 40), crowns(3, 1500, 5, hills(13, 6, 60), 0.5), near];
  const data = new Uint8Array(4 * WIDTH);
  lines.forEach((line, channel) => {
    for (let i = 0; i < WIDTH; i++) data[4 * i + channel] = Math.round(255 * line[i]!);
  });
  const texture = new DataTexture(data, WIDTH, 1);
  texture.wrapS = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.name = 'skylines';
  texture.needsUpdate = true;
  return texture;
}
