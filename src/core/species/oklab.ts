/** A colour by its lightness L (0..1) and two axes a (green to red) and b (blue to yellow): equal steps look equal (Ottosson 2020). */
export type Oklab = readonly [L: number, a: number, b: number];

const linear = (byte: number): number => {
  const v = byte / 255;
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
};

const byteOf = (light: number): number => {
  const v = Math.min(1, Math.max(0, light));
  return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
};

/** '#rrggbb', sRGB, as OKLab. */
export function oklabOf(colour: string): Oklab {
  const [r, g, b] = [1, 3, 5].map((at) => linear(Number.parseInt(colour.slice(at, at + 2), 16))) as [
    number,
    number,
    number,
  ];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** OKLab as '#rrggbb'; what the screen cannot show is the nearest that it can, channel by channel. */
export function colourOf([L, a, b]: Oklab): string {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const channels = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  return `#${channels.map((light) => byteOf(light).toString(16).padStart(2, '0')).join('')}`;
}

/** The colour `t` (0..1) of the way from one to another. */
export function mixColours(from: string, to: string, t: number): string {
  const [a, b] = [oklabOf(from), oklabOf(to)];
  return colourOf([0, 1, 2].map((i) => a[i]! + t * (b[i]! - a[i]!)) as unknown as Oklab);
}
