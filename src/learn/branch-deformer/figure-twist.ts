import { generatorCubic } from '../../core/deform/generator.ts';
import { handlesOf, projectedHandlesOf } from '../../core/math/frames.ts';
import { cross, dot } from '../../core/math/vec3.ts';
import { type FigureSpec, numberOf } from '../figure.ts';
import { Plane } from '../plane.ts';
import { signed } from '../signed.ts';
import { DEGREE, PARENT } from './example-branch.ts';
import { mostTwist } from './printed.ts';

/** Degrees by which Sloan's projection turns a handle about a joint that bends by `beta` in the direction `phi`, degrees, beside parallel transport. */
export function twistAt(beta: number, phi: number): number {
  const curve = generatorCubic(1, phi * DEGREE, beta * DEGREE, 0, 0);
  const [right, sloan] = [handlesOf(curve, PARENT), projectedHandlesOf(curve, PARENT)];
  return Math.atan2(dot(cross(right.t1, sloan.t1), right.l1), dot(right.t1, sloan.t1)) / DEGREE;
}

export const TWIST_FIGURE: FigureSpec = {
  id: 'twist',
  title: 'How much Sloan’s arrow twists',
  aspect: 2,
  controls: [
    { id: 'beta', label: 'Joint', unit: '°', min: 0, max: 120, step: 1, value: 60 },
    { id: 'phi', label: 'Direction of the bend', unit: '°', min: 0, max: 180, step: 1, value: 40 },
  ],
  readouts: [
    { id: 'twist', label: 'Twist here', unit: '°' },
    { id: 'most', label: 'Most, by the formula', unit: '°' },
    { id: 'transport', label: 'Parallel transport', unit: '°' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const most = (): number => {
      const beta = numberOf(host.values(), 'beta');
      return beta < 90 ? mostTwist(beta * DEGREE) / DEGREE : Number.NaN;
    };
    return {
      draw(values) {
        const beta = numberOf(values, 'beta');
        const bound = most();
        const high = beta < 90 ? Math.min(90, Math.max(15, 1.35 * bound)) : 200;
        plane.begin({ x: [0, 180], y: [-high, high], margin: { left: 48, bottom: 30, right: 18, top: 16 } });
        const colours = host.colours();
        plane.grid(30);
        plane.axes({ x: 'direction of the bend, degrees from S', y: 'twist, degrees' }, 30);
        plane.line([0, 0], [180, 0], { colour: colours.rest, width: 2, dash: [7, 5] });
        if (beta < 90) {
          for (const side of [-1, 1]) {
            plane.line([0, side * bound], [180, side * bound], { colour: colours.line, width: 1, dash: [2, 4] });
          }
          plane.graph((phi) => twistAt(beta, phi), { colour: colours.answer, width: 2.5 });
        } else {
          // Beyond the right angle the graph has jumps: no line joins their sides.
          for (let phi = 0; phi <= 180; phi += 0.5)
            plane.dot([phi, twistAt(beta, phi)], 1.4, { colour: colours.answer });
        }
        plane.text([178, 0], 'parallel transport', { colour: colours.rest, size: 12, align: 'right', shift: [0, -7] });
        return {
          twist: signed(twistAt(beta, numberOf(values, 'phi')), 1),
          most: beta < 90 ? bound.toFixed(1) : 'it flips',
          transport: '0.0',
        };
      },
      handles(values) {
        const [beta, phi] = [numberOf(values, 'beta'), numberOf(values, 'phi')];
        return [
          plane.handle({
            id: 'phi',
            label: 'Direction of the bend',
            ways: 'across',
            at: [phi, twistAt(beta, phi)],
            colour: host.colours().answer,
            said: `${phi} degrees, twist ${twistAt(beta, phi).toFixed(1)} degrees`,
            move: (x) => host.set('phi', x),
          }),
        ];
      },
      text: (values) =>
        `A joint of ${numberOf(values, 'beta')} degrees that bends in the direction of ${numberOf(values, 'phi')} degrees twists Sloan's arrow by ${twistAt(numberOf(values, 'beta'), numberOf(values, 'phi')).toFixed(1)} degrees.`,
    };
  },
};
