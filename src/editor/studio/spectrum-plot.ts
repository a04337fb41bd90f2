import uPlot from 'uplot';
import { plotWords } from '../words/studio-panels.ts';
import type { PlotColours } from './plot-colours.ts';
import { decibels, type SpectrumData } from './plot-data.ts';
import { followPointer, NO_BINDINGS, PLOT_FONT } from './time-plot.ts';
import { threeDigits } from './units.ts';

/** Decibels below the peak to which spectra are kept, and that are shown. */
export const FLOOR = -120;
const SHOWN = -50;

/** Hertz that are shown: slower than a minute's record can tell, and faster than any branch swings, are left out. */
const LOWEST = 0.06;
const HIGHEST = 10;

/** Spectra of force and displacement, each below its own peak, with the branch's own frequency marked. */
export class SpectrumPlot {
  readonly #plot: uPlot;
  #natural: number | null = null;
  readonly #colours: PlotColours;

  constructor(host: HTMLElement, colours: PlotColours, onPoint: (frequency: number | null) => void) {
    this.#colours = colours;
    const stroke = { stroke: colours.soft, font: PLOT_FONT, labelSize: 0 };
    const rule = { stroke: colours.hairline, width: 1 };
    const hertz = (_: uPlot, splits: number[]): (string | null)[] =>
      splits.map((s) => (/^[125]/.test(String(s).replace(/^0\.0*/, '')) ? String(s) : null));
    this.#plot = new uPlot(
      {
        width: Math.max(80, host.clientWidth),
        height: Math.max(40, host.clientHeight),
        padding: [6, 8, 0, 0],
        legend: { show: false },
        cursor: { y: false, drag: { x: false, y: false }, bind: NO_BINDINGS, points: { size: 7, width: 1.5 } },
        scales: {
          x: { time: false, distr: 3, range: () => [LOWEST, HIGHEST] },
          y: { range: () => [SHOWN, 3] },
        },
        axes: [
          {
            ...stroke,
            size: 22,
            gap: 2,
            grid: rule,
            ticks: { ...rule, size: 3 },
            splits: () => [0.1, 0.2, 0.5, 1, 2, 5, 10],
            values: hertz,
          },
          { ...stroke, size: 44, gap: 3, grid: rule, ticks: { ...rule, size: 3 }, splits: () => [0, -20, -40] },
        ],
        series: [
          {},
          { stroke: colours.force, width: 1.5, points: { show: false } },
          { stroke: colours.answer, width: 1.5, dash: [6, 3], points: { show: false } },
        ],
        hooks: { draw: [(u) => this.#drawNatural(u)] },
      },
      [[], [], []],
      host,
    );
    followPointer(
      this.#plot.over,
      (left) => {
        this.#plot.setCursor({ left, top: 0 }, false);
        onPoint(this.#plot.posToVal(left, 'x'));
      },
      () => {
        this.#plot.setCursor({ left: -10, top: 0 }, false);
        onPoint(null);
      },
    );
  }

  /** Draws the spectra; `natural` in hertz is marked. */
  draw({ frequency, force, displacement }: SpectrumData, natural: number | null): void {
    this.#natural = natural;
    // The mean has no place on a logarithmic axis.
    const columns = [frequency, decibels(force, FLOOR), decibels(displacement, FLOOR)].map((c) => c.subarray(1));
    this.#plot.setData(columns, true);
  }

  resize(width: number, height: number): void {
    if (width !== this.#plot.width || height !== this.#plot.height) this.#plot.setSize({ width, height });
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #drawNatural(u: uPlot): void {
    const natural = this.#natural;
    if (natural === null || natural < LOWEST || natural > HIGHEST) return;
    const { ctx, bbox } = u;
    const ratio = devicePixelRatio;
    const x = Math.round(u.valToPos(natural, 'x', true)) + 0.5;
    ctx.save();
    ctx.strokeStyle = this.#colours.reference;
    ctx.lineWidth = ratio;
    ctx.setLineDash([2 * ratio, 3 * ratio]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.fillStyle = this.#colours.soft;
    ctx.font = PLOT_FONT.replace('11px', `${11 * ratio}px`);
    const text = plotWords.own(threeDigits(natural));
    const room = bbox.left + bbox.width - x > ctx.measureText(text).width + 6 * ratio;
    ctx.textAlign = room ? 'left' : 'right';
    ctx.textBaseline = 'top';
    // On paper of its own, where lines run behind it.
    ctx.lineJoin = 'round';
    ctx.setLineDash([]);
    ctx.lineWidth = 4 * ratio;
    ctx.strokeStyle = this.#colours.paper;
    const place = [x + (room ? 4 : -4) * ratio, bbox.top + 2 * ratio] as const;
    ctx.strokeText(text, ...place);
    ctx.fillText(text, ...place);
    ctx.restore();
  }
}
