import { bezierPoint } from '../../core/math/bezier.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';
import { type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { Plane, type Point } from '../plane.ts';
import { errorsOf, type Impulse, impulse as impulseOf } from './chain.ts';

/** Steps a second while it runs, and steps until it begins anew. */
const RATE = 1.2;

class Impulses implements FigureStage {
  readonly #host: FigureHost;
  readonly #drawing: Plane;
  readonly #bars: Plane;
  #made: { values: Values; run: Impulse } | null = null;
  #clock = 0;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#drawing = new Plane(host);
    this.#bars = new Plane(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const levels = numberOf(values, 'levels');
    const count = levels + 1;
    if (this.#made?.values !== values)
      this.#made = { values, run: impulseOf(levels, numberOf(values, 'force'), count) };
    const { run } = this.#made;
    this.#clock = Math.floor(time * RATE);
    // From the rest, as step -1, to where all is right.
    const step = this.#step(values, count);
    const pose = step < 0 ? run.tree.restPose.data : (run.steps[step] ?? run.exact);
    const { size } = this.#host;
    const margin = marginsOf(size, { x: [0, 0.52], y: [0, 0.86] });
    this.#drawing.begin({ x: [-1.2, Math.max(1.5, 0.75 * levels)], y: [-0.2, levels + 0.2], equal: true, margin });
    const { rest, answer, line, wrong } = this.#host.colours();
    this.#drawing.line([this.#drawing.x[0], 0], [this.#drawing.x[1], 0], { colour: line, width: 1 });
    this.#chain(run, run.exact, () => rest, 9, 0.45);
    const errors = step < 0 ? errorsOf(run, run.tree.restPose.data) : errorsOf(run, pose);
    this.#chain(run, pose, (i) => ((errors[i] ?? 0) > 1e-4 ? wrong : answer), 4, 1);
    this.#errors(errors);
    this.#timeline(step, count);
    const off = errors.filter((error) => error > 1e-4).length;
    return {
      step: step < 0 ? 'before' : String(step),
      off: String(off),
      error: Math.max(...errors).toFixed(3),
    };
  }

  handles(values: Values) {
    const count = (this.#made?.run.tree.pieceCount ?? 5) + 1;
    const step = this.#step(values, count);
    const [x, y] = this.#spot(step, count);
    return [
      {
        id: 'step',
        label: 'Step',
        x,
        y,
        ways: 'across' as const,
        step: this.#gap(count),
        said: step < 0 ? 'before the impulse' : `step ${step}`,
        move: (px: number) => {
          const wanted = Math.round((px - this.#spot(-1, count)[0]) / this.#gap(count)) - 1;
          this.#host.set('ahead', numberOf(values, 'ahead') + Math.min(count - 1, Math.max(-1, wanted)) - step);
        },
      },
    ];
  }

  text(values: Values): string {
    const count = (this.#made?.run.tree.pieceCount ?? 5) + 1;
    return `At step ${this.#step(values, count)}: each step brings one more level to its place.`;
  }

  #step(values: Values, count: number): number {
    return ((((this.#clock + numberOf(values, 'ahead')) % (count + 1)) + count + 1) % (count + 1)) - 1;
  }

  #chain({ tree }: Impulse, pose: Float32Array, colour: (i: number) => string, width: number, alpha: number): void {
    const plane = planeOf(tree.restPose);
    for (let i = 0; i < tree.pieceCount; i++) {
      const { curve } = poseOf(pose, plane, i);
      const points = Array.from({ length: 17 }, (_, k): Point => {
        const [x, , z] = bezierPoint(curve, k / 16);
        return [x, z];
      });
      this.#drawing.polyline(points, { colour: colour(i), width: width * 0.9 ** i, alpha });
      const foot = points[0];
      if (foot) this.#drawing.dot(foot, width / 2 + 1, { colour: colour(i), alpha });
    }
  }

  #errors(errors: readonly number[]): void {
    const { size } = this.#host;
    const bars = this.#bars;
    const { wrong, answer, soft, hairline } = this.#host.colours();
    const most = Math.max(1, ...errors);
    const margin = marginsOf(size, { x: [0.52, 1], y: [0, 0.86] }, { left: 60, right: 46, top: 34, bottom: 12 });
    bars.begin({ x: [0, most], y: [-0.5, errors.length - 0.5], margin }, { keep: true });
    bars.text([0, errors.length - 0.5], 'off by, metres', {
      colour: soft,
      size: 12,
      baseline: 'bottom',
      shift: [0, -8],
    });
    errors.forEach((error, i) => {
      const fine = error < 1e-4;
      bars.line([0, i], [most, i], { colour: hairline, width: 1 });
      bars.text([0, i], `level ${i}`, { align: 'right', baseline: 'middle', shift: [-8, 0], colour: soft });
      if (fine)
        bars.text([0, i], 'right', {
          colour: answer,
          baseline: 'middle',
          shift: [6, 0],
        });
      else {
        bars.line([0, i], [error, i], { colour: wrong, width: 10 });
        bars.text([error, i], error.toFixed(2), { colour: wrong, baseline: 'middle', shift: [10, 0] });
      }
    });
  }

  #gap(count: number): number {
    return (this.#host.size.width - 72) / (count + 0.001);
  }

  #spot(step: number, count: number): Point {
    const { height } = this.#host.size;
    return [36 + (step + 1) * this.#gap(count), height * 0.92];
  }

  #timeline(step: number, count: number): void {
    const { line, soft, ink } = this.#host.colours();
    const plane = this.#bars;
    const at = (n: number): Point => plane.toWorld(...this.#spot(n, count));
    plane.line(at(-1), at(count - 1), { colour: line, width: 1 });
    for (let n = -1; n < count; n++) {
      plane.dot(at(n), 3, { colour: line });
      plane.text(at(n), n < 0 ? 'before' : String(n), {
        colour: n === step ? ink : soft,
        size: 12,
        align: 'center',
        baseline: 'top',
        shift: [0, 10],
      });
    }
  }
}

/** An impulse at the root, running up one level a step. */
export const impulse: FigureSpec = {
  id: 'impulse',
  title: 'An impulse, one level a step',
  aspect: 1.6,
  moves: true,
  begin: 2.6,
  controls: [
    { id: 'levels', label: 'Levels', min: 2, max: 7, step: 1, value: 5 },
    { id: 'force', label: 'Bend of the lowest', min: 0.2, max: 2, step: 0.1, value: 0.8 },
  ],
  // Steps that the reader has added to those of the clock.
  dragged: [{ id: 'ahead', min: -8, max: 8, step: 1, value: 0 }],
  readouts: [
    { id: 'step', label: 'Step' },
    { id: 'off', label: 'Levels not in their place' },
    { id: 'error', label: 'Farthest off', unit: 'm' },
  ],
  stage: (host) => new Impulses(host),
};
