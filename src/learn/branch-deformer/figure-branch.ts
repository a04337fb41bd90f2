import { edgesOf } from '../../core/math/frames.ts';
import { dot } from '../../core/math/vec3.ts';
import { type FigureSpec, numberOf } from '../figure.ts';
import { Plane } from '../plane.ts';
import { type Branch, rowsOf, stagePoint, straight } from './branch-mesh.ts';
import { branchOf, DEGREE, SHAPES, walk } from './example-branch.ts';
import { nearestValue } from './nearest-value.ts';
import { Orbit } from './orbit.ts';
import { type Eye, projector } from './solid.ts';
import { paintRows } from './surface-picture.ts';

const LENGTH = 2;
const RADIUS = 0.16;
const ROLL = 35;
const SECTORS = 28;
const BANDS = 40;
const STEPS = ['the sheet', 'a cylinder', 'a straight branch', 'a bent branch'] as const;

export const BRANCH_FIGURE: FigureSpec = {
  id: 'branch',
  title: 'From a sheet to a branch',
  aspect: 1.7,
  controls: [
    { id: 'step', label: 'Sheet, cylinder, branch, bent', min: 0, max: 3, step: 0.01, value: 3 },
    { id: 'b1', label: 'First joint', unit: '°', min: -85, max: 85, step: 1, value: 52 },
    { id: 'b2', label: 'Second joint', unit: '°', min: -85, max: 85, step: 1, value: -38 },
  ],
  readouts: [
    { id: 'vertices', label: 'Vertices' },
    { id: 'numbers', label: 'Numbers that place a branch' },
    { id: 'turn', label: 'From base to tip it turns by', unit: '°' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const orbit = new Orbit(host, 0.3, 0.3);
    const curveOf = (b1: number, b2: number) => walk(LENGTH, b1, b2, ROLL);
    const eyeNow = (): Eye => {
      const { width, height } = host.size;
      // What is straight lies lower.
      const risen = Math.min(1, Math.max(0, numberOf(host.values(), 'step') - 2));
      const scale = Math.min(width / 2.35, height / 1.45);
      return { ...orbit.angles, scale, centre: [LENGTH * 0.44, 0, 0.3 * risen], x: width / 2, y: height / 2 };
    };
    const bends = () => [numberOf(host.values(), 'b1'), numberOf(host.values(), 'b2')] as const;
    return {
      reset: () => orbit.reset(),
      draw(values) {
        plane.begin({ x: [0, 1], y: [0, 1] });
        const { context } = plane;
        const colours = host.colours();
        const step = numberOf(values, 'step');
        const curve = curveOf(...bends());
        const branch: Branch = branchOf(SHAPES.limb, RADIUS, curve);
        const eye = eyeNow();
        const rows = rowsOf(SECTORS, BANDS, (u, turns) => stagePoint(branch, LENGTH, step, u, turns));
        const wires = Math.max(0.1, 0.4 - 0.1 * step);
        const paper = Math.min(1, Math.max(0, 2 - step));
        paintRows(context, rows, eye, colours, { wires, paper });
        const shown = step >= 2 ? Math.min(1, step - 2) : 0;
        if (shown > 0) {
          const project = projector(eye);
          const flat = straight(LENGTH).curve;
          const points = (['p0', 'p1', 'p2', 'p3'] as const).map((key) =>
            project(
              [0, 1, 2].map((k) => flat[key][k]! * (1 - shown) + curve[key][k]! * shown) as [number, number, number],
            ),
          );
          context.strokeStyle = colours.rest;
          context.lineWidth = 1.5;
          context.setLineDash([5, 4]);
          context.beginPath();
          for (const [x, y] of points) context.lineTo(x, y);
          context.stroke();
          context.setLineDash([]);
          for (const [x, y] of points) {
            context.fillStyle = colours.rest;
            context.beginPath();
            context.arc(x, y, 4, 0, 7);
            context.fill();
          }
        }
        const [first, , last] = edgesOf(curve);
        const turn = shown * (Math.acos(Math.min(1, dot(first, last))) / DEGREE);
        return { vertices: (SECTORS + 1) * (BANDS + 1), numbers: 15, turn: turn.toFixed(0) };
      },
      handles() {
        if (numberOf(host.values(), 'step') < 3) return [];
        const project = projector(eyeNow());
        const [b1, b2] = bends();
        const curve = curveOf(b1, b2);
        const { rest } = host.colours();
        const pull = (id: 'b1' | 'b2', point: 'p2' | 'p3', label: string) => {
          const [x, y] = project(curve[point]);
          return {
            id,
            label,
            x,
            y,
            colour: rest,
            said: `${id === 'b1' ? b1 : b2} degrees`,
            move: (px: number, py: number) =>
              host.set(
                id,
                nearestValue(-85, 85, 1, (b) => {
                  const [qx, qy] = project(id === 'b1' ? curveOf(b, b2).p2 : curveOf(b1, b).p3);
                  return Math.hypot(qx - px, qy - py);
                }),
              ),
          };
        };
        return [pull('b1', 'p2', 'Third control point'), pull('b2', 'p3', 'Tip')];
      },
      text(values) {
        const step = numberOf(values, 'step');
        const name = STEPS[Math.round(step)] as string;
        return `${step === Math.round(step) ? 'Shown is' : 'On the way; nearest is'} ${name}, joints of ${numberOf(values, 'b1')} and ${numberOf(values, 'b2')} degrees.`;
      },
    };
  },
};
