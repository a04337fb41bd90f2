import type { Vec3 } from '../math/vec3.ts';

/** Heights in pixels between which a class of trees comes in (0, 1), and between which one that is nearer takes over (2, 3). */
export type Fade = readonly [from: number, to: number, lostFrom: number, lostTo: number];

/** Beyond all heights: no class takes over. */
export const NEVER = 1e9;

/** How high a tree is on screen, in pixels; `scale`: pixels of a metre at a metre. Twin: shaders/forest/fade.glsl. */
export function treePixels(foot: Readonly<Vec3>, height: number, eye: Readonly<Vec3>, scale: number): number {
  const away = Math.hypot(eye[0] - foot[0], eye[1] - foot[1], eye[2] - foot[2] - 0.5 * height);
  return (height * scale) / Math.max(away, 0.01);
}

/** Part of a tree, 0..1, that a class draws, and those nearer, whose band (from, to) it is. Twin: shaders/forest/fade.glsl. */
export function treeShare(from: number, to: number, pixels: number): number {
  const x = Math.min(1, Math.max(0, (pixels - from) / Math.max(to - from, 1e-3)));
  return x * x * (3 - 2 * x);
}

/**
 * The part that a class draws: from the first to the second of the noise; nothing where that is not above the first. `come`, `taken`: how
 * much of the tree is there in this class and in the nearer one, 0..1. Twin: shaders/forest/fade.glsl.
 */
export const treeShares = (fade: Fade, pixels: number, come = 1, taken = 1): [number, number] => [
  treeShare(fade[2], fade[3], pixels) * taken,
  treeShare(fade[0], fade[1], pixels) * come,
];

const fraction = (x: number): number => x - Math.floor(x);

/** Interleaved gradient noise of a pixel's middle, 0..1. Twin: shaders/forest/dither.glsl. Source: Jimenez 2014. */
export const ditherAt = (x: number, y: number): number =>
  fraction(52.9829189 * fraction(x * 0.06711056 + y * 0.00583715));

/** Is a pixel another class's to draw? `shares`: as `treeShares` has them. Twin: shaders/forest/dither.glsl. */
export function fadedOut(x: number, y: number, [low, high]: readonly [number, number]): boolean {
  const noise = ditherAt(x, y);
  return noise < low || noise >= high;
}
