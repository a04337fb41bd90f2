import type { TextureImages, TextureLayer } from '../../view/picture/picture.ts';
import type { PlotColours } from './plot-colours.ts';
import { paintAmounts, paintColours } from './texel-image.ts';

type Rgb = readonly [number, number, number];

const rgbOf = (hex: string): Rgb => {
  const n = Number.parseInt(hex.replace('#', ''), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
};

/** A texture on a canvas, a whole number of pixels a texel, with the texels that are pointed at marked. */
export class TexelCanvas {
  readonly element: HTMLCanvasElement;
  #small: OffscreenCanvas | null = null;
  #images: TextureImages | null = null;

  constructor(element: HTMLCanvasElement) {
    this.element = element;
  }

  paintColours(images: TextureImages, layer: TextureLayer): void {
    this.#paint(images, (out) => paintColours(layer, images.pieceCount, out));
  }

  /** Amounts from 0 to their greatest, from the colour `none` to `full`. */
  paintAmounts(images: TextureImages, values: Float32Array, none: string, full: string): void {
    const most = values.reduce((a, b) => Math.max(a, b), 0);
    this.#paint(images, (out) => paintAmounts(values, most, rgbOf(none), rgbOf(full), out));
  }

  /** Marks the texel that is pointed at, and that of the probe. */
  mark(highlight: number | null, probe: number | null, { ink, paper }: PlotColours): void {
    const images = this.#images;
    const context = this.element.getContext('2d');
    if (!images || !context) return;
    const cell = this.element.width / images.width;
    const ratio = devicePixelRatio;
    const ring = (piece: number, reach: number, dash: number[]): void => {
      const x = (piece % images.width) * cell;
      const y = Math.floor(piece / images.width) * cell;
      for (const [colour, width] of [
        [paper, 4 * ratio],
        [ink, 2 * ratio],
      ] as const) {
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.setLineDash(dash);
        context.strokeRect(x - reach, y - reach, cell + 2 * reach, cell + 2 * reach);
      }
      context.setLineDash([]);
    };
    if (probe !== null && probe < images.pieceCount) ring(probe, ratio, [3 * ratio, 2 * ratio]);
    if (highlight !== null && highlight < images.pieceCount) ring(highlight, 2 * ratio, []);
  }

  #paint(images: TextureImages, write: (out: Uint8ClampedArray) => void): void {
    this.#images = images;
    const { width, height } = images;
    if (this.#small?.width !== width || this.#small.height !== height) this.#small = new OffscreenCanvas(width, height);
    const small = this.#small.getContext('2d');
    const context = this.element.getContext('2d');
    const host = this.element.parentElement;
    if (!small || !context || !host) return;
    const room = Math.min(host.clientWidth, (host.clientHeight * width) / height);
    const cell = Math.max(1, Math.floor((room * devicePixelRatio) / width));
    const style = `width: ${(cell * width) / devicePixelRatio}px; height: ${(cell * height) / devicePixelRatio}px`;
    if (this.element.width !== cell * width || this.element.height !== cell * height) {
      this.element.width = cell * width;
      this.element.height = cell * height;
    }
    if (this.element.getAttribute('style') !== style) this.element.setAttribute('style', style);
    const pixels = small.createImageData(width, height);
    write(pixels.data);
    small.putImageData(pixels, 0, 0);
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, this.element.width, this.element.height);
    context.drawImage(this.#small, 0, 0, this.element.width, this.element.height);
  }
}
