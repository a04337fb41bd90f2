import type { WindState } from '../../core/wind/fade.ts';
import { windForce } from '../../core/wind/force.ts';
import { speedPerForce } from '../../core/wind/speed.ts';
import type { PlotColours } from './plot-colours.ts';

/** Cells of the map in each direction: finer than any wave that a tree feels, at any width of the map. */
export const CELLS = 48;

/** Arrows in each direction. */
const ARROWS = 10;

/** Force over the ground on a grid: speeds in metres a second, and their parts along x and y; row 0 is the lowest y. */
export interface Field {
  readonly speed: Float32Array;
  readonly x: Float32Array;
  readonly y: Float32Array;
}

/** Fills the grid with the force on a square of `width` metres around the tree, at `height` metres. */
export function fillField(state: WindState, width: number, height: number, out?: Field): Field {
  const field = out ?? {
    speed: new Float32Array(CELLS * CELLS),
    x: new Float32Array(CELLS * CELLS),
    y: new Float32Array(CELLS * CELLS),
  };
  for (let row = 0; row < CELLS; row++) {
    for (let column = 0; column < CELLS; column++) {
      const x = ((column + 0.5) / CELLS - 0.5) * width;
      const y = ((row + 0.5) / CELLS - 0.5) * width;
      const [fx, fy] = windForce(state, x, y, height);
      const i = row * CELLS + column;
      const perForce = speedPerForce(Math.hypot(fx, fy));
      field.x[i] = perForce * fx;
      field.y[i] = perForce * fy;
      field.speed[i] = Math.hypot(field.x[i]!, field.y[i]!);
    }
  }
  return field;
}

type Rgb = readonly [number, number, number];

const rgbOf = (hex: string): Rgb => {
  const n = Number.parseInt(hex.replace('#', ''), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
};

const mix = (a: Rgb, b: Rgb, f: number): Rgb => [
  a[0] + (b[0] - a[0]) * f,
  a[1] + (b[1] - a[1]) * f,
  a[2] + (b[2] - a[2]) * f,
];

/** From still air, which is paper, over the force's own blue to its deepest: one hue, ever further from the paper. */
export function fieldColour({ paper, force, ink }: PlotColours): (part: number) => Rgb {
  const [still, blue, deep] = [rgbOf(paper), rgbOf(force), mix(rgbOf(force), rgbOf(ink), 0.55)];
  return (part) => {
    const f = Math.min(1, Math.max(0, part));
    return f < 0.7 ? mix(still, blue, f / 0.7) : mix(blue, deep, (f - 0.7) / 0.3);
  };
}

/** What else the map shows. */
export interface MapMarks {
  /** Metres. */
  readonly width: number;
  /** Speed that has the deepest colour, metres a second. */
  readonly most: number;
  /** Radius of the crown, metres. */
  readonly crown: number;
  /** Where the probe is, metres. */
  readonly probe: readonly [number, number] | null;
  /** Where the keyboard's cursor is, metres; null: nowhere. */
  readonly cursor: readonly [number, number] | null;
  /** Direction in which the camera looks, radians from x to y. */
  readonly view: number;
}

const image = (): OffscreenCanvas => new OffscreenCanvas(CELLS, CELLS);

/** Draws fields on a canvas: colour by strength, arrows by strength and direction, the tree in the middle. */
export class FieldMap {
  readonly #canvas: HTMLCanvasElement;
  readonly #small = image();

  constructor(canvas: HTMLCanvasElement) {
    this.#canvas = canvas;
  }

  /** Makes it `size` CSS pixels in each direction, crisp at any pixel ratio. */
  resize(size: number): void {
    const pixels = Math.max(1, Math.round(size * devicePixelRatio));
    if (this.#canvas.width === pixels) return;
    this.#canvas.width = pixels;
    this.#canvas.height = pixels;
  }

  draw(field: Field, marks: MapMarks, colours: PlotColours): void {
    const context = this.#canvas.getContext('2d');
    const small = this.#small.getContext('2d');
    if (!context || !small) return;
    const size = this.#canvas.width;
    const colour = fieldColour(colours);
    const pixels = small.createImageData(CELLS, CELLS);
    for (let row = 0; row < CELLS; row++) {
      for (let column = 0; column < CELLS; column++) {
        const [r, g, b] = colour(field.speed[row * CELLS + column]! / marks.most);
        // y is up on the map, and down in an image.
        const at = 4 * ((CELLS - 1 - row) * CELLS + column);
        pixels.data[at] = r;
        pixels.data[at + 1] = g;
        pixels.data[at + 2] = b;
        pixels.data[at + 3] = 255;
      }
    }
    small.putImageData(pixels, 0, 0);
    context.imageSmoothingEnabled = true;
    context.imageSmoothingQuality = 'high';
    context.drawImage(this.#small, 0, 0, size, size);
    this.#arrows(context, field, marks, colours);
    this.#tree(context, marks, colours);
  }

  #arrows(context: CanvasRenderingContext2D, field: Field, { most }: MapMarks, { ink }: PlotColours): void {
    const size = this.#canvas.width;
    const cell = size / ARROWS;
    context.strokeStyle = ink;
    context.lineWidth = 1.2 * devicePixelRatio;
    context.lineCap = 'round';
    context.globalAlpha = 0.75;
    context.beginPath();
    for (let row = 0; row < ARROWS; row++) {
      for (let column = 0; column < ARROWS; column++) {
        const i = Math.floor(((row + 0.5) / ARROWS) * CELLS) * CELLS + Math.floor(((column + 0.5) / ARROWS) * CELLS);
        const speed = field.speed[i]!;
        if (speed < 0.02 * most) continue;
        const length = 0.85 * cell * Math.min(1, 0.15 + speed / most);
        const [dx, dy] = [field.x[i]! / speed, -field.y[i]! / speed];
        const [x, y] = [(column + 0.5) * cell, size - (row + 0.5) * cell];
        const [tipX, tipY] = [x + (dx * length) / 2, y + (dy * length) / 2];
        context.moveTo(x - (dx * length) / 2, y - (dy * length) / 2);
        context.lineTo(tipX, tipY);
        const barb = Math.min(length * 0.4, 5 * devicePixelRatio);
        context.moveTo(tipX - barb * (dx + 0.6 * dy), tipY - barb * (dy - 0.6 * dx));
        context.lineTo(tipX, tipY);
        context.lineTo(tipX - barb * (dx - 0.6 * dy), tipY - barb * (dy + 0.6 * dx));
      }
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  #tree(context: CanvasRenderingContext2D, marks: MapMarks, { answer, ink, paper }: PlotColours): void {
    const size = this.#canvas.width;
    const ratio = devicePixelRatio;
    const scale = size / marks.width;
    const at = ([x, y]: readonly [number, number]): [number, number] => [size / 2 + x * scale, size / 2 - y * scale];
    const ring = (x: number, y: number, r: number, colour: string, dash: number[] = []): void => {
      context.beginPath();
      context.setLineDash(dash);
      context.arc(x, y, r, 0, 2 * Math.PI);
      context.lineWidth = 3.5 * ratio;
      context.strokeStyle = paper;
      context.stroke();
      context.lineWidth = 1.5 * ratio;
      context.strokeStyle = colour;
      context.stroke();
      context.setLineDash([]);
    };
    ring(size / 2, size / 2, Math.max(4 * ratio, marks.crown * scale), answer);
    context.fillStyle = answer;
    context.beginPath();
    context.arc(size / 2, size / 2, 3 * ratio, 0, 2 * Math.PI);
    context.fill();
    if (marks.probe) {
      const [x, y] = at(marks.probe);
      ring(x, y, 4 * ratio, ink);
    }
    if (marks.cursor) {
      const [x, y] = at(marks.cursor);
      ring(x, y, 9 * ratio, ink, [4 * ratio, 3 * ratio]);
    }
    this.#eye(context, marks.view, ink, paper);
  }

  /** Where you stand: a small wedge on the rim. */
  #eye(context: CanvasRenderingContext2D, view: number, ink: string, paper: string): void {
    const size = this.#canvas.width;
    const ratio = devicePixelRatio;
    const [dx, dy] = [Math.cos(view), -Math.sin(view)];
    const rim = size / 2 - 12 * ratio;
    const reach = rim / Math.max(Math.abs(dx), Math.abs(dy));
    const [x, y] = [size / 2 - dx * reach, size / 2 - dy * reach];
    const r = 7 * ratio;
    context.beginPath();
    context.moveTo(x + dx * r, y + dy * r);
    context.lineTo(x - dx * r + dy * r * 0.8, y - dy * r - dx * r * 0.8);
    context.lineTo(x - dx * r - dy * r * 0.8, y - dy * r + dx * r * 0.8);
    context.closePath();
    context.fillStyle = ink;
    context.strokeStyle = paper;
    context.lineWidth = 1.5 * ratio;
    context.fill();
    context.stroke();
  }
}
