import type { FigureHost } from './figure.ts';
import type { Handle } from './handle.ts';
import { mapPlane, niceStep, type PlaneMap, type PlaneView, type Point, ticks } from './plane-map.ts';

export type { PlaneView, Point } from './plane-map.ts';

/** How a line or an area is drawn. */
export interface Style {
  /** CSS; default ink. */
  readonly colour?: string;
  /** CSS pixels; default 1.5. */
  readonly width?: number;
  readonly dash?: readonly number[];
  /** 0..1; default 1. */
  readonly alpha?: number;
}

/** How a text stands at its point. */
export interface TextStyle {
  readonly colour?: string;
  /** CSS pixels; default 13. */
  readonly size?: number;
  readonly align?: 'left' | 'center' | 'right';
  readonly baseline?: 'top' | 'middle' | 'bottom' | 'alphabetic';
  /** Pixels beside the point. */
  readonly shift?: Point;
  readonly italic?: boolean;
  readonly bold?: boolean;
  /** A rim of the paper's colour, so that lines under it do not cross it. Default true. */
  readonly rim?: boolean;
}

/** A handle whose place is in the world. */
export interface WorldHandle extends Omit<Handle, 'x' | 'y' | 'move'> {
  readonly at: Point;
  move(x: number, y: number): void;
}

/** A sheet of paper to draw on in the units of a world. Call `begin` first in every draw. */
export class Plane {
  readonly context: CanvasRenderingContext2D;
  readonly #host: FigureHost;
  #map: PlaneMap;

  constructor(host: FigureHost) {
    const context = host.canvas.getContext('2d');
    if (!context) throw new Error('the browser gives no 2D canvas.');
    this.context = context;
    this.#host = host;
    this.#map = mapPlane({ x: [0, 1], y: [0, 1] }, 1, 1);
  }

  /** Clears the sheet and lays `view` on it; `keep` leaves what is drawn, for a second view on the same sheet (give it margins). */
  begin(view: PlaneView, { keep = false }: { keep?: boolean } = {}): void {
    const { size, pixelRatio } = this.#host;
    this.context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    if (!keep) this.context.clearRect(0, 0, size.width, size.height);
    this.#map = mapPlane(view, size.width, size.height);
  }

  /** What of the world is shown, across and up. */
  get x(): readonly [number, number] {
    return this.#map.x;
  }

  get y(): readonly [number, number] {
    return this.#map.y;
  }

  /** CSS pixels a unit across, and up. */
  get scale(): Point {
    return [this.#map.scaleX, this.#map.scaleY];
  }

  toPixel(x: number, y: number): Point {
    return this.#map.toPixel(x, y);
  }

  toWorld(px: number, py: number): Point {
    return this.#map.toWorld(px, py);
  }

  /** The nearest point that is shown, `edge` units from the edges. */
  within([x, y]: Point, edge = 0): Point {
    const kept = (v: number, [from, to]: readonly [number, number]): number =>
      Math.min(Math.max(v, from + edge), to - edge);
    return [kept(x, this.x), kept(y, this.y)];
  }

  /** Hairlines every so many units; default a round step. */
  grid(stepX = niceStep(this.x[1] - this.x[0]), stepY = niceStep(this.y[1] - this.y[0])): void {
    const style = { colour: this.#host.colours().hairline, width: 1 };
    for (const x of ticks(this.x, stepX)) this.line([x, this.y[0]], [x, this.y[1]], style);
    for (const y of ticks(this.y, stepY)) this.line([this.x[0], y], [this.x[1], y], style);
  }

  /** Axes along the lower and left edge with numbers, and what they are; leave a margin of about 28 below and 44 at the left. */
  axes(names: { readonly x?: string; readonly y?: string } = {}, stepX?: number, stepY?: number): void {
    const { line, soft } = this.#host.colours();
    const [x0, x1] = this.x;
    const [y0, y1] = this.y;
    this.polyline(
      [
        [x0, y1],
        [x0, y0],
        [x1, y0],
      ],
      { colour: line, width: 1 },
    );
    const size = 12;
    const across = stepX ?? niceStep(x1 - x0);
    const up = stepY ?? niceStep(y1 - y0, 5);
    for (const x of ticks(this.x, across))
      this.text([x, y0], String(x), { size, colour: soft, align: 'center', baseline: 'top', shift: [0, 6] });
    for (const y of ticks(this.y, up))
      this.text([x0, y], String(y), { size, colour: soft, align: 'right', baseline: 'middle', shift: [-6, 0] });
    if (names.x) this.text([x1, y0], names.x, { size, align: 'right', baseline: 'bottom', shift: [0, -6] });
    if (names.y) this.text([x0, y1], names.y, { size, align: 'left', baseline: 'top', shift: [8, 0] });
  }

  line(a: Point, b: Point, style: Style = {}): void {
    this.polyline([a, b], style);
  }

  polyline(points: readonly Point[], style: Style = {}): void {
    this.#path(points);
    this.#stroke(style);
  }

  /** An area; `colour` fills it. */
  area(points: readonly Point[], { colour, alpha = 1 }: Style = {}): void {
    this.#path(points);
    this.context.globalAlpha = alpha;
    this.context.fillStyle = colour ?? this.#host.colours().ink;
    this.context.fill();
    this.context.globalAlpha = 1;
  }

  /** The curve y = f(x) over what is shown, or over a part of it. */
  graph(f: (x: number) => number, style: Style = {}, [from, to]: Point = this.x): void {
    const steps = Math.max(2, Math.ceil(((to - from) * this.#map.scaleX) / 2));
    this.polyline(
      Array.from({ length: steps + 1 }, (_, i): Point => {
        const x = from + ((to - from) * i) / steps;
        return [x, f(x)];
      }),
      style,
    );
  }

  /** A line with a head at `b`; its head keeps its size. */
  arrow(a: Point, b: Point, style: Style = {}): void {
    const from = this.toPixel(...a);
    const to = this.toPixel(...b);
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const long = Math.hypot(dx, dy);
    if (long < 0.5) return;
    const { width = 1.5 } = style;
    const head = Math.min(6 + 2 * width, long);
    const [ux, uy] = [dx / long, dy / long];
    const { context } = this;
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(to[0] - ux * head * 0.8, to[1] - uy * head * 0.8);
    this.#stroke(style);
    context.globalAlpha = style.alpha ?? 1;
    context.fillStyle = style.colour ?? this.#host.colours().ink;
    context.beginPath();
    context.moveTo(...to);
    context.lineTo(to[0] - ux * head - uy * head * 0.42, to[1] - uy * head + ux * head * 0.42);
    context.lineTo(to[0] - ux * head + uy * head * 0.42, to[1] - uy * head - ux * head * 0.42);
    context.fill();
    context.globalAlpha = 1;
  }

  /** A filled dot of a radius in CSS pixels. */
  dot(at: Point, radius = 3, { colour, alpha = 1 }: Style = {}): void {
    const { context } = this;
    context.beginPath();
    context.arc(...this.toPixel(...at), radius, 0, 2 * Math.PI);
    context.globalAlpha = alpha;
    context.fillStyle = colour ?? this.#host.colours().ink;
    context.fill();
    context.globalAlpha = 1;
  }

  /** A circle of a radius in units of the world across. */
  circle(at: Point, radius: number, style: Style = {}): void {
    this.context.beginPath();
    this.context.arc(...this.toPixel(...at), radius * this.#map.scaleX, 0, 2 * Math.PI);
    this.#stroke(style);
  }

  text(at: Point, text: string, style: TextStyle = {}): void {
    const {
      colour,
      size = 13,
      align = 'left',
      baseline = 'alphabetic',
      shift = [0, 0],
      italic,
      bold,
      rim = true,
    } = style;
    const { context } = this;
    const colours = this.#host.colours();
    const [x, y] = this.toPixel(...at);
    context.font = `${italic ? 'italic ' : ''}${bold ? '600 ' : ''}${size}px system-ui, sans-serif`;
    context.textAlign = align;
    context.textBaseline = baseline;
    const [px, py] = [this.#inside(x + shift[0], context.measureText(text)), y + shift[1]];
    if (rim) {
      context.strokeStyle = colours.well;
      context.lineWidth = 4;
      context.lineJoin = 'round';
      context.strokeText(text, px, py);
    }
    context.fillStyle = colour ?? colours.ink;
    context.fillText(text, px, py);
  }

  /** Draws without what lies beyond the view. */
  clipped(draw: () => void): void {
    const { context } = this;
    const [left, top] = this.toPixel(this.x[0], this.y[1]);
    const [right, bottom] = this.toPixel(this.x[1], this.y[0]);
    context.save();
    context.beginPath();
    context.rect(left, top, right - left, bottom - top);
    context.clip();
    draw();
    context.restore();
  }

  /** What `FigureStage.handles` returns for a point of the world; keys move it by `step` pixels. */
  handle({ at, move, ...rest }: WorldHandle): Handle {
    const [x, y] = this.toPixel(...at);
    return { ...rest, x, y, move: (px, py) => move(...this.toWorld(px, py)) };
  }

  /** Where a text begins or ends that shall not be cut by the edge of the stage. */
  #inside(x: number, { actualBoundingBoxLeft, actualBoundingBoxRight }: TextMetrics): number {
    const last = this.#host.size.width - 4 - actualBoundingBoxRight;
    return Math.max(4 + actualBoundingBoxLeft, Math.min(last, x));
  }

  #path(points: readonly Point[]): void {
    const { context } = this;
    context.beginPath();
    points.forEach(([x, y], i) => {
      const [px, py] = this.toPixel(x, y);
      if (i === 0) context.moveTo(px, py);
      else context.lineTo(px, py);
    });
  }

  #stroke({ colour, width = 1.5, dash = [], alpha = 1 }: Style): void {
    const { context } = this;
    context.globalAlpha = alpha;
    context.strokeStyle = colour ?? this.#host.colours().ink;
    context.lineWidth = width;
    context.lineCap = 'round';
    context.lineJoin = 'round';
    context.setLineDash([...dash]);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }
}
