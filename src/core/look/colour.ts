import { power } from '../grow/elementary.ts';

/** Red, green and blue, linear, 0..1. */
export type Colour = readonly [red: number, green: number, blue: number];

/** One part of a colour from sRGB (0..1) to linear. The same in every engine. */
export const fromSrgb = (c: number): number => (c <= 0.04045 ? c / 12.92 : power((c + 0.055) / 1.055, 2.4));

/** One part of a colour from linear (0..1) to sRGB. */
export const toSrgb = (c: number): number => (c <= 0.0031308 ? 12.92 * c : 1.055 * power(c, 1 / 2.4) - 0.055);

/** '#rrggbb' as a linear colour. */
export function colourOf(hex: string): Colour {
  const part = (at: number): number => fromSrgb(Number.parseInt(hex.slice(at, at + 2), 16) / 255);
  return [part(1), part(3), part(5)];
}

/** (1 - f) a + f b. */
export const mixColours = (a: Colour, b: Colour, f: number): Colour => [
  a[0] * (1 - f) + b[0] * f,
  a[1] * (1 - f) + b[1] * f,
  a[2] * (1 - f) + b[2] * f,
];

/** A part of 0..1 in eight bits. */
export const byte = (x: number): number => Math.round(255 * Math.min(1, Math.max(0, x)));
