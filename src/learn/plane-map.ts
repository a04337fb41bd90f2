/** The part of the plane that a figure shows, in the units of its world. */
export interface PlaneView {
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  /** One unit is as long across as up: the view grows to fill the stage. Default false. */
  readonly equal?: boolean;
  /** Free pixels around it; default 16, and room for the names of axes is the figure's to ask for. */
  readonly margin?: Partial<Margin>;
}

export interface Margin {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

export type Point = readonly [number, number];

/** How the world lies on the stage; y points up in the world and down on the stage. */
export interface PlaneMap {
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  /** CSS pixels a unit. */
  readonly scaleX: number;
  readonly scaleY: number;
  toPixel(x: number, y: number): Point;
  toWorld(px: number, py: number): Point;
}

const EDGE = 16;

/** Lays a view into a stage of so many CSS pixels. */
export function mapPlane(view: PlaneView, width: number, height: number): PlaneMap {
  const { top = EDGE, right = EDGE, bottom = EDGE, left = EDGE } = view.margin ?? {};
  const [wide, high] = [Math.max(1, width - left - right), Math.max(1, height - top - bottom)];
  let [spanX, spanY] = [view.x[1] - view.x[0], view.y[1] - view.y[0]];
  if (view.equal) {
    const units = Math.max(spanX / wide, spanY / high);
    [spanX, spanY] = [units * wide, units * high];
  }
  const middle = (range: readonly [number, number]): number => (range[0] + range[1]) / 2;
  const x: [number, number] = [middle(view.x) - spanX / 2, middle(view.x) + spanX / 2];
  const y: [number, number] = [middle(view.y) - spanY / 2, middle(view.y) + spanY / 2];
  const [scaleX, scaleY] = [wide / spanX, high / spanY];
  return {
    x,
    y,
    scaleX,
    scaleY,
    toPixel: (wx, wy) => [left + (wx - x[0]) * scaleX, top + (y[1] - wy) * scaleY],
    toWorld: (px, py) => [x[0] + (px - left) / scaleX, y[1] - (py - top) / scaleY],
  };
}

/** A round step (1, 2 or 5 times a power of ten) that divides `span` into about `parts`. */
export function niceStep(span: number, parts = 6): number {
  const rough = Math.abs(span) / Math.max(1, parts);
  const power = 10 ** Math.floor(Math.log10(rough));
  const lead = rough / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

/** Multiples of `step` in a range, without the noise of sums. */
export function ticks([from, to]: readonly [number, number], step: number): number[] {
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
