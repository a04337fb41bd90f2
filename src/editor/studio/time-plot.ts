import uPlot from 'uplot';
import type { PlotColours } from './plot-colours.ts';

/** One line of a plot over time. */
export interface Line {
  readonly label: string;
  readonly colour: keyof PlotColours;
  /** Lengths of dash and gap in pixels; empty: solid. Lines of one plot differ by it, never by colour alone. */
  readonly dash: readonly number[];
  /** Filled down to 0 with the softer colour. */
  readonly area?: boolean;
}

export interface TimePlotOptions {
  readonly lines: readonly Line[];
  readonly colours: PlotColours;
  /** Whether the axis of time is drawn: the lowest of several plots has it. */
  readonly axis: boolean;
  /** The reader points at a time, or no longer (null). */
  readonly onPoint: (time: number | null) => void;
}

/** Pixels that axes take: plots above one another line up. */
const LEFT = 44;
const BOTTOM = 22;

export const PLOT_FONT = '11px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif';

/** No event of the mouse is uPlot's: pointers of all kinds are handled here. */
const none = (): null => null;
export const NO_BINDINGS = {
  mousedown: none,
  mouseup: none,
  click: none,
  dblclick: none,
  mousemove: none,
  mouseleave: none,
  mouseenter: none,
} as const;

/** Tells of each place that a pointer is at over a plot, and when it leaves; `left` in CSS pixels of the plotting area. */
export function followPointer(
  over: HTMLElement,
  onMove: (left: number, top: number) => void,
  onLeave: () => void,
): void {
  const move = (event: PointerEvent): void => {
    const box = over.getBoundingClientRect();
    onMove(event.clientX - box.left, event.clientY - box.top);
  };
  over.addEventListener('pointermove', move);
  over.addEventListener('pointerdown', move);
  over.addEventListener('pointerleave', onLeave);
  over.addEventListener('pointercancel', onLeave);
}

/** Values over time in a scrolling window: a thin skin around uPlot that knows the house's colours and how times are pointed at. */
export class TimePlot {
  readonly #plot: uPlot;
  #from = 0;
  #to = 1;
  #range: [number, number] = [0, 1];
  /** Where the pointer is; the time under it changes while the plot scrolls. */
  #pointer: number | null = null;
  readonly #onPoint: TimePlotOptions['onPoint'];

  constructor(host: HTMLElement, { lines, colours, axis, onPoint }: TimePlotOptions) {
    this.#onPoint = onPoint;
    const stroke = { stroke: colours.soft, font: PLOT_FONT, labelSize: 0 };
    const rule = { stroke: colours.hairline, width: 1 };
    this.#plot = new uPlot(
      {
        width: Math.max(80, host.clientWidth),
        height: Math.max(40, host.clientHeight),
        padding: [6, 8, axis ? 0 : 4, 0],
        legend: { show: false },
        cursor: { y: false, drag: { x: false, y: false }, bind: NO_BINDINGS, points: { size: 7, width: 1.5 } },
        scales: {
          x: { time: false, range: () => [this.#from, this.#to] },
          y: { range: () => this.#range },
        },
        axes: [
          {
            ...stroke,
            show: axis,
            size: BOTTOM,
            gap: 2,
            grid: { ...rule, show: true },
            ticks: { ...rule, size: 3 },
            space: 44,
          },
          { ...stroke, size: LEFT, gap: 3, grid: rule, ticks: { ...rule, size: 3 }, space: 16 },
        ],
        series: [
          {},
          ...lines.map((line) => ({
            label: line.label,
            stroke: colours[line.colour],
            width: line.dash.length > 0 ? 1.25 : 1.5,
            dash: [...line.dash],
            points: { show: false },
            ...(line.area ? { fill: colours.forceSoft, fillTo: 0 } : {}),
          })),
        ],
      },
      [[], ...lines.map(() => [])],
      host,
    );
    followPointer(
      this.#plot.over,
      (left) => {
        this.#pointer = left;
        this.#point();
      },
      () => {
        this.#pointer = null;
        this.#onPoint(null);
      },
    );
  }

  /** Draws columns (time first) from `from` to `to` seconds, with values within `range`. */
  draw(columns: readonly Float64Array[], from: number, to: number, range: [number, number]): void {
    this.#from = from;
    this.#to = to;
    this.#range = range;
    this.#plot.setData(columns as Float64Array[], true);
    if (this.#pointer !== null) this.#point();
  }

  /** Marks a time, or none. */
  mark(time: number | null): void {
    const left = time === null ? -10 : this.#plot.valToPos(time, 'x');
    this.#plot.setCursor({ left: left >= 0 && left <= this.#plot.over.clientWidth ? left : -10, top: 0 }, false);
  }

  resize(width: number, height: number): void {
    if (width !== this.#plot.width || height !== this.#plot.height) this.#plot.setSize({ width, height });
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #point(): void {
    if (this.#pointer === null) return;
    this.#onPoint(this.#plot.posToVal(this.#pointer, 'x'));
  }
}
