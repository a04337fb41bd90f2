import uPlot from 'uplot';
import type { PlotColours } from './plot-colours.ts';
import { followPointer, NO_BINDINGS, PLOT_FONT } from './time-plot.ts';

/** Parts of the trail that fade, the oldest first. */
const PARTS = 6;

/** Pixels within which a point of the trail is pointed at. */
const NEAR = 24;

/** Displacement against velocity: a trail that fades with age, the newest place as a dot, the marked time as a ring. */
export class PhasePlot {
  readonly #plot: uPlot;
  readonly #colours: PlotColours;
  #time: Float64Array = new Float64Array(0);
  #x: Float64Array = new Float64Array(0);
  #y: Float64Array = new Float64Array(0);
  #xRange: [number, number] = [-1, 1];
  #yRange: [number, number] = [-1, 1];
  #mark = -1;

  constructor(host: HTMLElement, colours: PlotColours, onPoint: (time: number | null) => void) {
    this.#colours = colours;
    const stroke = { stroke: colours.soft, font: PLOT_FONT, labelSize: 0 };
    const rule = { stroke: colours.hairline, width: 1 };
    this.#plot = new uPlot(
      {
        width: Math.max(80, host.clientWidth),
        height: Math.max(40, host.clientHeight),
        padding: [6, 10, 0, 0],
        legend: { show: false },
        cursor: {
          show: true,
          x: false,
          y: false,
          drag: { x: false, y: false },
          bind: NO_BINDINGS,
          points: { show: false },
        },
        scales: {
          x: { time: false, range: () => this.#xRange },
          y: { range: () => this.#yRange },
        },
        axes: [
          { ...stroke, size: 22, gap: 2, grid: rule, ticks: { ...rule, size: 3 }, space: 40 },
          { ...stroke, size: 44, gap: 3, grid: rule, ticks: { ...rule, size: 3 }, space: 22 },
        ],
        // The trail is no function of its x: uPlot draws the axes, the hook below the rest.
        series: [{}, { show: true, stroke: colours.velocity, paths: () => null, points: { show: false } }],
        hooks: { draw: [(u) => this.#drawTrail(u)] },
      },
      [[], []],
      host,
    );
    followPointer(
      this.#plot.over,
      (left, top) => onPoint(this.#timeAt(left, top)),
      () => onPoint(null),
    );
  }

  /** Draws the trail of `x` (displacement) and `y` (velocity) at the times of `time`. */
  draw(
    time: Float64Array,
    x: Float64Array,
    y: Float64Array,
    ranges: { readonly x: [number, number]; readonly y: [number, number] },
  ): void {
    this.#time = time;
    this.#x = x;
    this.#y = y;
    this.#xRange = ranges.x;
    this.#yRange = ranges.y;
    this.#plot.setData([[...ranges.x], [0, 0]], true);
  }

  /** Marks the reading at place `at` of the trail; -1: none. */
  mark(at: number): void {
    if (at === this.#mark) return;
    this.#mark = at;
    this.#plot.redraw(false, false);
  }

  resize(width: number, height: number): void {
    if (width !== this.#plot.width || height !== this.#plot.height) this.#plot.setSize({ width, height });
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #timeAt(left: number, top: number): number | null {
    let best = NEAR * NEAR;
    let found: number | null = null;
    for (let i = 0; i < this.#x.length; i++) {
      const dx = this.#plot.valToPos(this.#x[i]!, 'x') - left;
      const dy = this.#plot.valToPos(this.#y[i]!, 'y') - top;
      const apart = dx * dx + dy * dy;
      if (apart <= best) {
        best = apart;
        found = this.#time[i]!;
      }
    }
    return found;
  }

  #drawTrail(u: uPlot): void {
    const { ctx, bbox } = u;
    const n = this.#x.length;
    if (n < 2) return;
    const ratio = devicePixelRatio;
    const [x0, x1] = this.#xRange;
    const [y0, y1] = this.#yRange;
    const kx = bbox.width / (x1 - x0);
    const ky = bbox.height / (y1 - y0);
    const px = (i: number): number => bbox.left + (this.#x[i]! - x0) * kx;
    const py = (i: number): number => bbox.top + bbox.height - (this.#y[i]! - y0) * ky;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.lineWidth = 1.25 * ratio;
    ctx.lineJoin = 'round';
    ctx.strokeStyle = this.#colours.velocity;
    for (let part = 0; part < PARTS; part++) {
      const from = Math.floor((n * part) / PARTS);
      const to = Math.min(n - 1, Math.floor((n * (part + 1)) / PARTS));
      ctx.globalAlpha = 0.18 + (0.82 * part) / (PARTS - 1);
      ctx.beginPath();
      ctx.moveTo(px(from), py(from));
      for (let i = from + 1; i <= to; i++) ctx.lineTo(px(i), py(i));
      ctx.stroke();
    }
    ctx.globalAlpha = 1;
    ctx.fillStyle = this.#colours.answer;
    ctx.beginPath();
    ctx.arc(px(n - 1), py(n - 1), 3.5 * ratio, 0, 2 * Math.PI);
    ctx.fill();
    if (this.#mark >= 0 && this.#mark < n) {
      ctx.strokeStyle = this.#colours.ink;
      ctx.lineWidth = 1.5 * ratio;
      ctx.beginPath();
      ctx.arc(px(this.#mark), py(this.#mark), 5 * ratio, 0, 2 * Math.PI);
      ctx.stroke();
    }
    ctx.restore();
  }
}
