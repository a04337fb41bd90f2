import type { Plane, Point } from '../plane.ts';

/** A texture drawn large: cells of a world unit each, row 0 at the top; `x`, `y`: its upper left corner. */
export class TexelGrid {
  readonly width: number;
  readonly height: number;
  readonly x: number;
  readonly y: number;

  constructor(width: number, height: number, x: number, y: number) {
    this.width = width;
    this.height = height;
    this.x = x;
    this.y = y;
  }

  /** Middle of the texel of piece i. */
  at(i: number): Point {
    return [this.x + (i % this.width) + 0.5, this.y - Math.floor(i / this.width) - 0.5];
  }

  cell(plane: Plane, i: number, colour: string, alpha = 1): void {
    const [x, y] = this.at(i);
    const [left, top] = plane.toPixel(x - 0.5, y + 0.5);
    const [right, low] = plane.toPixel(x + 0.5, y - 0.5);
    const { context } = plane;
    context.globalAlpha = alpha;
    context.fillStyle = colour;
    context.fillRect(left + 0.5, top + 0.5, right - left - 1, low - top - 1);
    context.globalAlpha = 1;
  }

  /** A stripe along the lower edge of a cell. */
  strip(plane: Plane, i: number, colour: string, alpha = 1): void {
    const [x, y] = this.at(i);
    const [left, low] = plane.toPixel(x - 0.5, y - 0.5);
    const [right] = plane.toPixel(x + 0.5, y);
    const high = Math.max(2, 0.22 * plane.scale[1]);
    const { context } = plane;
    context.globalAlpha = alpha;
    context.fillStyle = colour;
    context.fillRect(left + 0.5, low - 0.5 - high, right - left - 1, high);
    context.globalAlpha = 1;
  }

  outline(plane: Plane, i: number, colour: string, width = 2.5): void {
    const [x, y] = this.at(i);
    const h = 0.5;
    plane.polyline(
      [
        [x - h, y - h],
        [x + h, y - h],
        [x + h, y + h],
        [x - h, y + h],
        [x - h, y - h],
      ],
      { colour, width },
    );
  }

  /** The texel under a pixel; -1: none. */
  pick(plane: Plane, px: number, py: number): number {
    const [x, y] = plane.toWorld(px, py);
    const [column, row] = [Math.floor(x - this.x), Math.floor(this.y - y)];
    if (column < 0 || column >= this.width || row < 0 || row >= this.height) return -1;
    return row * this.width + column;
  }
}
