import { flare, lobes, powerTaper } from '../../core/deform/radius.ts';
import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane } from '../plane.ts';
import { signed } from '../signed.ts';
import { printedFlareSlope, printedLobesByAngle, printedTaperSlope } from './printed.ts';

/** A factor of the radius over what it is differentiated by, its slope, and the slope in print. */
interface Factor {
  readonly x: readonly [from: number, to: number];
  readonly y: readonly [from: number, to: number];
  readonly name: string;
  readonly along: string;
  value(x: number): number;
  slope(x: number): number;
  printed(x: number): number;
}

const TAU = 2 * Math.PI;

/** The three factors whose slopes are misprinted, with the numbers of the paper's pictures. */
export const FACTORS: Readonly<Record<string, Factor>> = {
  taper: {
    x: [0, 1],
    y: [0, 1.2],
    name: 'taper, t = 3',
    along: 'along the branch, u',
    value: (u) => powerTaper(u, 1, 3)[0],
    slope: (u) => powerTaper(u, 1, 3)[1],
    printed: (u) => printedTaperSlope(u, 1, 3),
  },
  flare: {
    x: [0, 1],
    y: [0.9, 1.4],
    name: 'flare, f = 0.33',
    along: 'along the branch, u',
    value: (u) => flare(u, 0.33)[0],
    slope: (u) => flare(u, 0.33)[1],
    printed: (u) => printedFlareSlope(u, 0.33),
  },
  lobes: {
    x: [0, TAU],
    y: [0.8, 1.2],
    name: '7 lobes, 0.2 deep, fade 1, at u = 0.5',
    along: 'around the branch, θ',
    value: (angle) => lobes(0.5, angle / TAU, 7, 0.2, 1)[0],
    slope: (angle) => lobes(0.5, angle / TAU, 7, 0.2, 1)[2],
    printed: (angle) => printedLobesByAngle(0.5, angle, 7, 0.2, 1),
  },
};

/** Slope by a small difference, which no misprint can touch. */
export const differenced = ({ value }: Pick<Factor, 'value'>, x: number): number =>
  (value(x + 1e-5) - value(x - 1e-5)) / 2e-5;

const factorOf = (values: Values): Factor => FACTORS[choiceOf(values, 'factor')] as Factor;
const short = (x: number): string => signed(x, Math.abs(x) >= 100 ? 0 : 3);

export const SLOPE_FIGURE: FigureSpec = {
  id: 'slope',
  title: 'Does the slope fit its curve?',
  aspect: 2,
  controls: [
    {
      id: 'factor',
      label: 'Factor',
      options: [
        { value: 'taper', label: 'taper' },
        { value: 'flare', label: 'flare' },
        { value: 'lobes', label: 'lobes' },
      ],
      value: 'taper',
    },
    {
      id: 'form',
      label: 'Slope',
      options: [
        { value: 'right', label: 'corrected' },
        { value: 'printed', label: 'as printed' },
      ],
      value: 'printed',
    },
    { id: 'at', label: 'Place', min: 0, max: 1, step: 0.005, value: 0.6 },
  ],
  readouts: [
    { id: 'slope', label: 'Slope by the formula' },
    { id: 'true', label: 'By a small difference' },
    { id: 'off', label: 'Apart' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const place = (values: Values): number => {
      const { x } = factorOf(values);
      return x[0] + numberOf(values, 'at') * (x[1] - x[0]);
    };
    return {
      draw(values) {
        const factor = factorOf(values);
        plane.begin({ x: factor.x, y: factor.y, margin: { left: 52, bottom: 32, right: 20, top: 18 } });
        const colours = host.colours();
        const wrong = choiceOf(values, 'form') === 'printed';
        const at = place(values);
        const [value, slope] = [factor.value(at), wrong ? factor.printed(at) : factor.slope(at)];
        plane.grid();
        plane.axes({ x: factor.along, y: factor.name });
        plane.graph(factor.value, { colour: colours.ink, width: 2 });
        // As long in the picture whatever the slope.
        const [sx, sy] = plane.scale;
        const reach = Math.min(160, host.size.width / 4) / Math.hypot(sx, slope * sy);
        plane.line([at - reach, value - slope * reach], [at + reach, value + slope * reach], {
          colour: wrong ? colours.wrong : colours.answer,
          width: 2.5,
          ...(wrong ? { dash: [8, 5] } : {}),
        });
        const measured = differenced(factor, at);
        return { slope: short(slope), true: short(measured), off: short(Math.abs(slope - measured)) };
      },
      handles(values) {
        const factor = factorOf(values);
        const at = place(values);
        return [
          plane.handle({
            id: 'at',
            label: 'Place on the curve',
            ways: 'across',
            at: [at, factor.value(at)],
            said: at.toFixed(2),
            move: (x) => host.set('at', (x - factor.x[0]) / (factor.x[1] - factor.x[0])),
          }),
        ];
      },
      text(values) {
        const factor = factorOf(values);
        const at = place(values);
        const slope = choiceOf(values, 'form') === 'printed' ? factor.printed(at) : factor.slope(at);
        return `${factor.name}, at ${at.toFixed(2)}: the formula gives a slope of ${short(slope)}, a small difference ${short(differenced(factor, at))}.`;
      },
    };
  },
};
