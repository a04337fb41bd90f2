import type { PackedTree } from '../../core/pack/packed.ts';
import type { Wind } from '../../core/wind/wind.ts';
import { DEFAULT_WAVE } from '../../core/wind/wind.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { Plane, type Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { windOf } from '../sum-of-sines/waves.ts';
import { apartByDepth, type BothPoses, bothPoses } from './lag-run.ts';
import { smallTree } from './small-tree.ts';
import { smallTreeLink } from './small-tree-link.ts';
import { TreeDrawing } from './tree-drawing.ts';

/** A swell along x that passes `frequency` times a second. */
export const swell = (amplitude: number, frequency: number): Wind =>
  windOf([{ ...DEFAULT_WAVE, amplitude, wavelength: 24, speed: 24 * frequency, sharpness: 1, direction: -0.6 }], {
    pose: 'lagged',
  });

/** The arrow of the swell beside the tree, as long as it pushes: its foot and its tip. */
const reach = (amplitude: number): readonly [Point, Point] => [
  [-2.5, 5.9],
  [-2.5 + amplitude, 5.9],
];

class Lagged extends PlaneFigure {
  readonly #tree: PackedTree;
  readonly #drawing: TreeDrawing;
  readonly #bars: Plane;
  #values: Values | null = null;
  #most: number[] = [];
  #fastest: number[] = [];
  #last: { step: number; poses: BothPoses } | null = null;

  constructor(host: FigureHost) {
    super(host);
    this.#tree = smallTree().packed;
    this.#drawing = new TreeDrawing(this.#tree);
    this.#bars = new Plane(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const rate = numberOf(values, 'rate');
    const wind = swell(numberOf(values, 'amplitude'), numberOf(values, 'frequency'));
    if (values !== this.#values) {
      this.#values = values;
      this.#most = [];
      this.#fastest = [];
      this.#last = null;
      // A whole swell at once, so that the bars do not begin at nothing.
      const turns = Math.ceil(rate / numberOf(values, 'frequency'));
      for (let n = 0; n < 40; n++) this.#measure(wind, Math.round((turns * n) / 40), rate);
    }
    const poses = this.#measure(wind, Math.floor(time * rate), rate);
    const { size } = this.host;
    const bars = { x: [0.56, 1] } as const;
    this.plane.begin({ x: [-2.6, 2.8], y: [-0.1, 6.2], equal: true, margin: marginsOf(size, { x: [0, 0.56] }) });
    const colours = this.host.colours();
    this.plane.line([this.plane.x[0], 0], [this.plane.x[1], 0], { colour: colours.line, width: 1 });
    this.#drawing.draw(this.plane, poses.exact, colours, () => ({ colour: colours.rest, wider: 2, alpha: 0.5 }));
    this.#drawing.draw(this.plane, poses.lagged, colours, () => ({ colour: colours.answer }));
    const [from, to] = reach(numberOf(values, 'amplitude'));
    this.plane.arrow(from, to, { colour: colours.force, width: 3 });
    this.#chart(bars, rate);
    const last = this.#most.length - 1;
    const bound = (last / rate) * (this.#fastest[last] ?? 0);
    return {
      error: (1000 * (this.#most[last] ?? 0)).toFixed(1),
      bound: (1000 * bound).toFixed(1),
      late: ((1000 * last) / rate).toFixed(0),
    };
  }

  handles(values: Values) {
    const amplitude = numberOf(values, 'amplitude');
    return [
      this.plane.handle({
        id: 'amplitude',
        label: 'Amplitude of the swell',
        at: reach(amplitude)[1],
        ways: 'across',
        colour: this.host.colours().force,
        said: `${amplitude} metres`,
        move: (x) => this.host.set('amplitude', x - reach(0)[0][0]),
      }),
    ];
  }

  text(): string {
    const last = this.#most.length - 1;
    return `The outermost twigs of the lagged tree are up to ${(1000 * (this.#most[last] ?? 0)).toFixed(0)} millimetres from their place.`;
  }

  #measure(wind: Wind, step: number, rate: number): BothPoses {
    if (this.#last?.step === step) return this.#last.poses;
    const poses = bothPoses(this.#tree, wind, step, rate);
    const before = bothPoses(this.#tree, wind, step - 1, rate);
    apartByDepth(this.#tree, poses.exact, poses.lagged).forEach((apart, d) => {
      this.#most[d] = Math.max(this.#most[d] ?? 0, apart);
    });
    apartByDepth(this.#tree, poses.exact, before.exact).forEach((moved, d) => {
      this.#fastest[d] = Math.max(this.#fastest[d] ?? 0, moved * rate);
    });
    this.#last = { step, poses };
    return poses;
  }

  #chart(part: Parameters<typeof marginsOf>[1], rate: number): void {
    const bars = this.#bars;
    const { wrong, soft, ink, hairline } = this.host.colours();
    const bounds = this.#most.map((_, d) => ((1000 * d) / rate) * (this.#fastest[d] ?? 0));
    const most = Math.max(1, ...bounds, ...this.#most.map((m) => 1000 * m)) * 1.25;
    const margin = marginsOf(this.host.size, part, { left: 62, right: 14, top: 40, bottom: 30 });
    bars.begin({ x: [0, most], y: [-0.5, this.#most.length - 0.5], margin }, { keep: true });
    bars.text([0, this.#most.length - 0.5], 'off by, mm', {
      colour: soft,
      size: 12,
      baseline: 'bottom',
      shift: [0, -8],
    });
    this.#most.forEach((error, d) => {
      bars.line([0, d], [most, d], { colour: hairline, width: 1 });
      bars.line([0, d], [1000 * error, d], { colour: wrong, width: 10 });
      bars.text([0, d], `depth ${d}`, { colour: soft, align: 'right', baseline: 'middle', shift: [-8, 0] });
      bars.text([1000 * error, d], (1000 * error).toFixed(1), {
        colour: wrong,
        baseline: 'bottom',
        shift: [6, -7],
        size: 12,
      });
      const bound = bounds[d] ?? 0;
      if (d > 0) bars.line([bound, d - 0.28], [bound, d + 0.28], { colour: ink, width: 2 });
    });
  }
}

/** The small tree, lagged and exact. */
export const lagged: FigureSpec = {
  id: 'lagged',
  title: 'Lagged against exact',
  aspect: 1.5,
  moves: true,
  begin: 1.1,
  controls: [
    { id: 'amplitude', label: 'Amplitude of the swell', unit: 'm', min: 0.05, max: 1.5, step: 0.05, value: 0.8 },
    { id: 'frequency', label: 'Swells a second', unit: 'Hz', min: 0.1, max: 2, step: 0.05, value: 0.5 },
    { id: 'rate', label: 'Steps a second', min: 10, max: 120, step: 1, value: 20 },
  ],
  readouts: [
    { id: 'error', label: 'Outermost twigs off by', unit: 'mm' },
    { id: 'bound', label: 'Bound d Δt v', unit: 'mm' },
    { id: 'late', label: 'They are late by', unit: 'ms' },
  ],
  open: (values) => smallTreeLink(swell(numberOf(values, 'amplitude'), numberOf(values, 'frequency'))),
  stage: (host) => new Lagged(host),
};
