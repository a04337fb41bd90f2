import { bezierPoint, type Cubic } from '../../core/math/bezier.ts';
import { handlesOf, sectionFrame } from '../../core/math/frames.ts';
import { add, addScaled, type Vec3 } from '../../core/math/vec3.ts';
import { attachByAngles } from '../../core/wind/attach-angles.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { attachAxes, leanOf, printedAxis } from './printed-axis.ts';

const DEGREE = Math.PI / 180;
/** From where it is seen: turned about the vertical, and from above. */
const [TURN, ABOVE] = [0.55, 0.3];
const O: Vec3 = [1, 0, 0];
/** The child as it was grown: its foot at the origin, along x. */
const CHILD: Cubic = { p0: [0, 0, 0], p1: [0.35, 0, 0], p2: [0.7, 0.06, 0], p3: [1.02, 0.2, 0] };
const RADIUS = 0.13;

const flat = ([x, y, z]: Vec3): Point => {
  const away = x * Math.sin(TURN) + y * Math.cos(TURN);
  return [x * Math.cos(TURN) - y * Math.sin(TURN), z * Math.cos(ABOVE) + away * Math.sin(ABOVE)];
};

/** The point of the plane y = 0 that is seen there. */
const lift = (sx: number, sy: number): Vec3 => {
  const x = sx / Math.cos(TURN);
  return [x, 0, (sy - x * Math.sin(TURN) * Math.sin(ABOVE)) / Math.cos(ABOVE)];
};

/** The parent as its end has been dragged. */
function parentOf(values: Values): Cubic {
  const [x, z] = [numberOf(values, 'endX'), numberOf(values, 'endZ')];
  return { p0: [0, 0, 0], p1: [0, 0, 0.75], p2: [0.22 * x, 0, 0.75 + 0.55 * (z - 0.75) + 0.25], p3: [x, 0, z] };
}

class Attachment extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const plane = this.plane;
    const colours = this.host.colours();
    const { rest, wrong, answer, level0, soft } = colours;
    const [v, theta, alpha] = this.#of(values);
    const parent = parentOf(values);
    plane.begin({ x: [-0.9, 2], y: [-0.15, 2.3], equal: true });
    this.#tube(parent);
    this.#curve(parent, { colour: level0, width: 3 });
    const at = bezierPoint(parent, v);
    const axes = attachAxes(parent, O, v, theta);
    const printed = printedAxis(parent, O, v, theta);
    const child = attachByAngles(parent, O, v, { theta, alpha, roll: 0 }, CHILD).curve;
    // The angle alpha, from U towards V.
    const arc = Array.from({ length: 25 }, (_, i) => {
      const a = (alpha * i) / 24;
      return flat(addScaled(addScaled(at, axes[0], 0.34 * Math.cos(a)), axes[1], 0.34 * Math.sin(a)));
    });
    plane.polyline(arc, { colour: soft, width: 1.2 });
    const middle = arc[12];
    if (middle) plane.text(middle, 'α', { italic: true, size: 15, shift: [6, -2] });
    axes.forEach((axis, i) => {
      const tip = addScaled(at, axis, 0.62);
      plane.arrow(flat(at), flat(tip), { colour: rest, width: 2.5 });
      plane.text(flat(tip), 'UVW'[i] ?? '', { italic: true, bold: true, size: 15, colour: rest, shift: [6, -6] });
    });
    const wrongTip = addScaled(at, printed, 0.62);
    plane.arrow(flat(at), flat(wrongTip), { colour: wrong, width: 2.5 });
    plane.text(flat(wrongTip), 'V printed', { colour: wrong, size: 13, align: 'right', shift: [-6, 14] });
    this.#curve(child, { colour: answer, width: 5 });
    plane.polyline([child.p0, child.p1, child.p2, child.p3].map(flat), { colour: answer, width: 1, dash: [3, 3] });
    plane.text(flat(child.p3), 'child', { colour: answer, shift: [8, 4] });
    plane.text(flat(parent.p1), 'parent', { colour: level0, align: 'right', shift: [-24, 0] });
    return {
      lean: Math.abs(leanOf(printed, axes[0])).toFixed(1),
      right: signed(leanOf(axes[1], axes[0]), 1),
      apart: (
        Math.acos(Math.min(1, printed[0] * axes[1][0] + printed[1] * axes[1][1] + printed[2] * axes[1][2])) / DEGREE
      ).toFixed(1),
    };
  }

  handles(values: Values) {
    const plane = this.plane;
    const host = this.host;
    const parent = parentOf(values);
    const [v] = this.#of(values);
    return [
      plane.handle({
        id: 'end',
        label: 'End of the parent',
        at: flat(parent.p3),
        colour: host.colours().level0,
        move: (x, y) => {
          const [ex, , ez] = lift(x, y);
          host.set('endX', ex);
          host.set('endZ', ez);
        },
      }),
      plane.handle({
        id: 'foot',
        label: 'Foot of the child',
        at: flat(bezierPoint(parent, v)),
        colour: host.colours().answer,
        said: `v is ${v}`,
        move: (x, y) => host.set('v', nearest(parent, x, y)),
      }),
    ];
  }

  text(values: Values): string {
    const [v, theta] = this.#of(values);
    const parent = parentOf(values);
    const lean = leanOf(printedAxis(parent, O, v, theta), attachAxes(parent, O, v, theta)[0]);
    return `A child grows on a bent parent. The printed axis V leans by ${Math.abs(lean).toFixed(1)} degrees.`;
  }

  #of(values: Values): [v: number, theta: number, alpha: number] {
    return [numberOf(values, 'v'), numberOf(values, 'theta') * DEGREE, numberOf(values, 'alpha') * DEGREE];
  }

  #curve(curve: Cubic, style: { colour: string; width: number }): void {
    this.plane.polyline(
      Array.from({ length: 41 }, (_, i) => flat(bezierPoint(curve, i / 40))),
      style,
    );
  }

  /** Rings across the parent: its bark. */
  #tube(parent: Cubic): void {
    const handles = handlesOf(parent, O);
    const { level0 } = this.host.colours();
    for (let k = 0; k <= 14; k++) {
      const u = k / 14;
      const at = bezierPoint(parent, u);
      const [, t, s] = sectionFrame(parent, handles, u);
      const radius = RADIUS * (1 - 0.6 * u);
      const ring = Array.from({ length: 33 }, (_, i): Point => {
        const a = (2 * Math.PI * i) / 32;
        return flat(
          add(
            at,
            addScaled(
              [t[0] * radius * Math.cos(a), t[1] * radius * Math.cos(a), t[2] * radius * Math.cos(a)],
              s,
              radius * Math.sin(a),
            ),
          ),
        );
      });
      this.plane.area(ring, { colour: level0, alpha: 0.1 });
      this.plane.polyline(ring, { colour: level0, width: 1, alpha: 0.55 });
    }
  }
}

/** The parameter of the curve that is seen nearest to a point of the sheet. */
function nearest(curve: Cubic, x: number, y: number): number {
  let [best, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i <= 100; i++) {
    const [px, py] = flat(bezierPoint(curve, i / 100));
    const far = Math.hypot(px - x, py - y);
    if (far < least) [best, least] = [i / 100, far];
  }
  return best;
}

/** The paper's figure 4: a child placed on its parent. */
export const attachment: FigureSpec = {
  id: 'attachment',
  title: 'A child on its parent',
  aspect: 1.5,
  controls: [
    { id: 'v', label: 'Along the parent, v', min: 0.05, max: 1, step: 0.01, value: 0.62 },
    { id: 'theta', label: 'Around it, θ', unit: '°', min: -180, max: 180, step: 1, value: 150 },
    { id: 'alpha', label: 'Away from it, α', unit: '°', min: 0, max: 140, step: 1, value: 62 },
  ],
  dragged: [
    { id: 'endX', min: -1.2, max: 2, step: 0.001, value: 1.5 },
    { id: 'endZ', min: 0.5, max: 2.5, step: 0.001, value: 1.5 },
  ],
  readouts: [
    { id: 'lean', label: 'Printed V off the right angle', unit: '°' },
    { id: 'right', label: 'Ours', unit: '°' },
    { id: 'apart', label: 'Between the two', unit: '°' },
  ],
  stage: (host) => new Attachment(host),
};
