import { DEFAULT_GUST } from '../../core/wind/wind.ts';
import { choiceOf, type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { smallTreeLink } from '../ping-pong/small-tree-link.ts';
import { Plane, type Point } from '../plane.ts';
import { tunedWind } from './models.ts';
import { eulerStates, exactStates, overshootOf, overshootTheory, periodOf, type State } from './oscillate.ts';

const SECONDS = 6;
const COUNT = 60 * SECONDS + 1;
const TARGET = 1;

/** Where it starts: its velocity is dragged in units of omega, as the plane has it. */
const startOf = (values: Values): State => [
  numberOf(values, 'q'),
  2 * Math.PI * numberOf(values, 'frequency') * numberOf(values, 'v'),
];

class Step implements FigureStage {
  readonly #host: FigureHost;
  readonly #phase: Plane;
  readonly #time: Plane;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#phase = new Plane(host);
    this.#time = new Plane(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const { size } = this.#host;
    const { answer, wrong, rest, soft, line } = this.#host.colours();
    const [damping, omega] = [numberOf(values, 'damping'), 2 * Math.PI * numberOf(values, 'frequency')];
    const euler = choiceOf(values, 'form') === 'euler';
    const states = (euler ? eulerStates : exactStates)(startOf(values), TARGET, omega, damping, COUNT);
    const colour = euler ? wrong : answer;
    const [left, right] = [{ x: [0, 0.45] }, { x: [0.45, 1] }] as const;
    // Velocity in units of omega: then a swing without damping is a circle.
    const phase = states.map(([q, v]): Point => [q, v / omega]);
    const shown = Math.max(2, Math.floor(60 * (time % (SECONDS + 1))));
    this.#phase.begin({
      x: [-0.6, 2.4],
      y: [-1.5, 1.5],
      equal: true,
      margin: marginsOf(size, left, { left: 12, bottom: 12 }),
    });
    const plane = this.#phase;
    plane.line([plane.x[0], 0], [plane.x[1], 0], { colour: line, width: 1 });
    plane.line([TARGET, plane.y[0]], [TARGET, plane.y[1]], { colour: rest, width: 1, dash: [4, 4] });
    plane.text([plane.x[1], plane.y[0]], 'displacement →', { size: 12, colour: soft, align: 'right', shift: [0, -4] });
    plane.text([TARGET, plane.y[1]], 'velocity/ω ↑', { size: 12, colour: soft, baseline: 'top', shift: [6, 2] });
    this.#path(plane, phase, shown, colour);
    plane.dot([TARGET, 0], 4, { colour: rest });
    const chart = this.#time;
    chart.begin(
      { x: [0, SECONDS], y: [-0.6, 2.4], margin: marginsOf(size, right, { left: 40, bottom: 30, top: 14, right: 14 }) },
      { keep: true },
    );
    chart.grid(1, 1);
    chart.axes({ x: 'seconds', y: 'displacement' }, 1, 1);
    chart.line([0, TARGET], [SECONDS, TARGET], { colour: rest, dash: [4, 4] });
    this.#path(
      chart,
      states.map(([q], n): Point => [n / 60, q]),
      shown,
      colour,
    );
    // From rest, whatever has been dragged: what the formulas speak of.
    const fromRest = (euler ? eulerStates : exactStates)([0, 0], TARGET, omega, damping, 20 * COUNT);
    const period = periodOf(fromRest, TARGET);
    return {
      far: Math.max(...states.map(([q]) => q)).toFixed(2),
      over: `${(100 * overshootOf(fromRest.slice(0, COUNT), TARGET)).toFixed(1)}`,
      theory: (100 * overshootTheory(damping)).toFixed(1),
      period: Number.isNaN(period) ? 'none' : period.toFixed(3),
      periodTheory: damping < 1 ? ((2 * Math.PI) / (omega * Math.sqrt(1 - damping * damping))).toFixed(3) : 'none',
    };
  }

  handles(values: Values) {
    const [q, v] = [numberOf(values, 'q'), numberOf(values, 'v')];
    return [
      this.#phase.handle({
        id: 'start',
        label: 'Start of the branch',
        at: [q, v],
        said: `displacement ${q.toFixed(2)}, velocity ${v.toFixed(2)} ω`,
        move: (x, y) => {
          const [toQ, toV] = this.#phase.within([x, y]);
          this.#host.set('q', toQ);
          this.#host.set('v', toV);
        },
      }),
    ];
  }

  text(values: Values): string {
    const damping = numberOf(values, 'damping');
    const way = choiceOf(values, 'form') === 'euler' ? 'stepped by explicit Euler' : 'stepped exactly';
    return `A branch that starts at displacement ${numberOf(values, 'q')} and comes to rest at 1, ${way}. With a damping of ${damping} it goes, from rest, ${(100 * overshootTheory(damping)).toFixed(0)} per cent too far by theory.`;
  }

  #path(plane: Plane, points: readonly Point[], shown: number, colour: string): void {
    plane.clipped(() => {
      plane.polyline(points, { colour, width: 1.2, alpha: 0.35 });
      const past = points.slice(0, shown);
      plane.polyline(past, { colour, width: 1.6 });
      for (const point of past) plane.dot(point, 1.8, { colour });
      const now = past.at(-1);
      if (now) plane.dot(now, 5, { colour });
    });
  }
}

/** A spring after a step of the wind: phase portrait and response. */
export const step: FigureSpec = {
  id: 'step',
  title: 'A branch after a push',
  aspect: 1.75,
  moves: true,
  begin: 3,
  controls: [
    { id: 'damping', label: 'Damping ζ', min: 0, max: 2, step: 0.01, value: 0.12 },
    { id: 'frequency', label: 'Natural frequency', unit: 'Hz', min: 0.2, max: 4, step: 0.05, value: 0.8 },
    {
      id: 'form',
      label: 'Step',
      value: 'exact',
      options: [
        { value: 'exact', label: 'Exact' },
        { value: 'euler', label: 'Explicit Euler' },
      ],
    },
  ],
  dragged: [
    { id: 'q', min: -3, max: 4, step: 0.01, value: 0 },
    { id: 'v', min: -3, max: 3, step: 0.01, value: 0 },
  ],
  readouts: [
    { id: 'far', label: 'Farthest displacement' },
    { id: 'over', label: 'Too far by, from rest', unit: '%' },
    { id: 'theory', label: 'By theory', unit: '%' },
    { id: 'period', label: 'One swing', unit: 's' },
    { id: 'periodTheory', label: 'By theory', unit: 's' },
  ],
  open: (values) =>
    smallTreeLink(
      tunedWind('A push that stays', numberOf(values, 'frequency'), numberOf(values, 'damping'), {
        gusts: [{ ...DEFAULT_GUST, start: 1, amplitude: 0.4, rise: 0.02, fall: 60, width: 0, speed: 40, repeat: 12 }],
      }),
    ),
  stage: (host) => new Step(host),
};
