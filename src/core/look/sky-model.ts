/** Red, green and blue. */
export type Rgb = readonly [number, number, number];

/** Where the sun stands, degrees: above the horizon, and from north by east. */
export interface SunPlace {
  readonly elevation: number;
  readonly azimuth: number;
}

export const RADIAN = Math.PI / 180;

/** A day in June in the middle latitudes: long enough for every light there is, with a night in it. */
const LATITUDE = 47 * RADIAN;
const DECLINATION = 22 * RADIAN;

/** The sun of a summer day. `hour` by the sun: at 12 it is in the south; 24 is 0 again. */
export function sunAt(hour: number): SunPlace {
  const turn = ((hour - 12) / 12) * Math.PI;
  const up = Math.sin(LATITUDE) * Math.sin(DECLINATION) + Math.cos(LATITUDE) * Math.cos(DECLINATION) * Math.cos(turn);
  const west = Math.sin(turn);
  const south = Math.cos(turn) * Math.sin(LATITUDE) - Math.tan(DECLINATION) * Math.cos(LATITUDE);
  return {
    elevation: Math.asin(up) / RADIAN,
    azimuth: (180 + Math.atan2(west, south) / RADIAN) % 360,
  };
}

/** Optical depth of clear air straight up for the three colours: Rayleigh's scattering at 650, 570 and 475 nm. */
const RAYLEIGH: Rgb = [0.05, 0.087, 0.18];

/** Air that a ray at an elevation in degrees goes through, in heights of the atmosphere (Kasten and Young 1989). */
const airMass = (elevation: number): number => {
  const e = Math.max(0, elevation);
  return 1 / (Math.sin(e * RADIAN) + 0.50572 * (e + 6.07995) ** -1.6364);
};

/** What the air leaves of sunlight, linear, its largest part 1: white overhead, amber when it is low. */
export function sunTint(elevation: number): Rgb {
  const mass = Math.min(airMass(elevation), 16);
  const [r, g, b] = RAYLEIGH.map((depth) => Math.exp(-depth * mass)) as unknown as Rgb;
  return [1, g / r, b / r];
}

/** Numbers that follow the sun's elevation: [degrees, value], upwards; between them on a straight line. */
export type Curve<T> = readonly (readonly [number, T])[];

export const mixRgb = (a: Rgb, b: Rgb, t: number): Rgb => a.map((c, k) => c + (b[k]! - c) * t) as unknown as Rgb;

/** The two keys around an elevation, and how far it is from the one to the other. */
function around<T>(curve: Curve<T>, elevation: number): [T, T, number] {
  let next = 1;
  while (next < curve.length - 1 && curve[next]![0] < elevation) next++;
  const [from, a] = curve[next - 1]!;
  const [to, b] = curve[next]!;
  return [a, b, Math.min(1, Math.max(0, (elevation - from) / (to - from)))];
}

export function along(curve: Curve<number>, elevation: number): number {
  const [a, b, t] = around(curve, elevation);
  return a + (b - a) * t;
}

/** A colour `#rrggbb` as three numbers 0..1, as it stands. */
export const rgb = (hex: string): Rgb => {
  const n = Number.parseInt(hex.slice(1), 16);
  return [(n >> 16) / 255, ((n >> 8) & 255) / 255, (n & 255) / 255];
};

export function tintAlong(curve: Curve<string>, elevation: number): Rgb {
  const [a, b, t] = around(curve, elevation);
  return mixRgb(rgb(a), rgb(b), t);
}

/** A colour of the screen (sRGB) as light, and back. */
const toLinear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const toScreen = (c: number): number => (c <= 0.0031308 ? c * 12.92 : 1.055 * c ** (1 / 2.4) - 0.055);

export const linearOf = ([r, g, b]: Rgb): Rgb => [toLinear(r), toLinear(g), toLinear(b)];
export const screenOf = ([r, g, b]: Rgb): Rgb => [toScreen(r), toScreen(g), toScreen(b)];
