import { type Shape, skjermoRadius } from '../../core/deform/radius.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { PLAIN } from './example-branch.ts';
import { nearestValue } from './nearest-value.ts';

const BULGES = 5;
/** Where the handles of bulges and taper sit: on the second swelling, and on the shoulder. */
const CREST = (1 + 1 / 4) / BULGES;
const SHOULDER = 0.75;

const shapeOf = (values: Values): Shape => ({
  ...PLAIN,
  taper: numberOf(values, 't'),
  flare: numberOf(values, 'f'),
  bulges: BULGES,
  bulgeDepth: numberOf(values, 'b'),
});

/** Radius over the cylinder's at u. */
const radiusAt = (shape: Shape, u: number): number => skjermoRadius(shape, 1, u, 0)[0];

export const PROFILE_FIGURE: FigureSpec = {
  id: 'profile',
  title: 'The radius along a stem',
  aspect: 1.8,
  controls: [
    { id: 't', label: 'Taper t', min: 0.2, max: 12, step: 0.1, value: 2 },
    { id: 'f', label: 'Flare f', min: 0, max: 1.5, step: 0.01, value: 0.6 },
    { id: 'b', label: 'Depth of the bulges', min: 0, max: 0.4, step: 0.01, value: 0.05 },
  ],
  readouts: [
    { id: 'foot', label: 'Radius at the foot', unit: 'r' },
    { id: 'middle', label: 'Radius halfway', unit: 'r' },
    { id: 'half', label: 'Half as thick as r at u =' },
  ],
  open: (values) =>
    `s=quaking-aspen&seed=1&leaves=0&tree.flare=${numberOf(values, 'f')}&tree.bulges=${BULGES}&tree.bulgeDepth=${numberOf(values, 'b')}`,
  stage: (host) => {
    const plane = new Plane(host);
    return {
      draw(values) {
        plane.begin({ x: [0, 1], y: [-2.4, 2.4], margin: { left: 48, bottom: 30, right: 22, top: 14 } });
        const colours = host.colours();
        const shape = shapeOf(values);
        const steps = Array.from({ length: 241 }, (_, i) => i / 240);
        const upper = steps.map((u): Point => [u, radiusAt(shape, u)]);
        const lower = upper.map(([u, r]): Point => [u, -r]).toReversed();
        plane.grid(0.25, 1);
        plane.area([...upper, ...lower], { colour: colours.level1, alpha: 0.35 });
        const cylinder = { colour: colours.rest, width: 1, dash: [4, 4] };
        plane.line([0, 1], [1, 1], cylinder);
        plane.line([0, -1], [1, -1], cylinder);
        plane.text([0.98, 1], 'the cylinder, r', { colour: colours.rest, size: 12, align: 'right', shift: [0, -7] });
        plane.line([0, 0], [1, 0], { colour: colours.rest, width: 1.5, dash: [8, 3, 2, 3] });
        plane.polyline(upper, { colour: colours.level0, width: 2 });
        plane.polyline(lower, { colour: colours.level0, width: 2 });
        plane.axes({ x: 'along the branch, u', y: 'radius / r' }, 0.25, 1);
        const half = steps.find((u) => u > 0.1 && radiusAt(shape, u) <= 0.5);
        return {
          foot: radiusAt(shape, 0).toFixed(2),
          middle: radiusAt(shape, 0.5).toFixed(3),
          half: half === undefined ? 'nowhere' : half.toFixed(2),
        };
      },
      handles(values) {
        const shape = shapeOf(values);
        const { level0 } = host.colours();
        const pull = (id: 't' | 'f' | 'b', label: string, u: number, [min, max, step]: [number, number, number]) =>
          plane.handle({
            id,
            label,
            ways: 'up',
            at: [u, radiusAt(shape, u)],
            colour: level0,
            said: String(numberOf(values, id)),
            move: (_, y) =>
              host.set(
                id,
                nearestValue(min, max, step, (value) =>
                  Math.abs(radiusAt(shapeOf({ ...host.values(), [id]: value }), u) - y),
                ),
              ),
          });
        return [
          pull('f', 'Flare', 0, [0, 1.5, 0.01]),
          pull('b', 'Depth of the bulges', CREST, [0, 0.4, 0.01]),
          pull('t', 'Taper', SHOULDER, [0.2, 12, 0.1]),
        ];
      },
      text(values) {
        const shape = shapeOf(values);
        return `The stem is ${radiusAt(shape, 0).toFixed(2)} r thick at the foot, ${radiusAt(shape, 0.5).toFixed(2)} halfway and 0 at the tip.`;
      },
    };
  },
};
