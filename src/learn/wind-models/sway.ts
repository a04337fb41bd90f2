import { MECHANICS, MECHANICS_SIZE, SWAY_LAYERS } from '../../core/pack/layout.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { swayClock, swayParts, swayRate, swaySwing, swayTexels, swayUniform } from '../../core/wind/sway.ts';
import { STILL, type SwaySettings } from '../../core/wind/wind.ts';
import { choiceOf, type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { smallTree } from '../ping-pong/small-tree.ts';
import { smallTreeLink } from '../ping-pong/small-tree-link.ts';
import { Plane, type Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { niceStep } from '../plane-map.ts';
import { longLimb } from './three.ts';

/** Seconds of the path. */
const PAST = 120;
const RADIANS = Math.PI / 180;

const settingsOf = (values: Values): SwaySettings => ({
  speed: numberOf(values, 'speed'),
  gust: numberOf(values, 'gust'),
  reading: 'ratio',
  rate: choiceOf(values, 'rate') === 'printed' ? 1 / 15 : STILL.sway.rate,
});

/** The swing of a limb of the small tree at a time, along its two axes: degrees at its tip. */
export function limbSwing(settings: SwaySettings): (time: number) => Point {
  const { packed } = smallTree();
  const limb = longLimb(packed);
  const texels = swayTexels(packed, settings);
  const texel = (layer: number): number[] => {
    const at = layerStart(texels, layer) + 4 * limb;
    return Array.from(texels.data.subarray(at, at + 4));
  };
  const [gain, offset] = [texel(SWAY_LAYERS.GAIN), texel(SWAY_LAYERS.OFFSET)];
  const uniform = swayUniform(settings, 1, new Float64Array(4));
  const clock = new Float64Array(2);
  const degrees = (gain[1] ?? 0) / RADIANS;
  return (time) => {
    const [x, y] = swaySwing(gain, offset, uniform, swayClock(time, clock));
    return [x * degrees, y * degrees];
  };
}

/** a0 of the limb, degrees: what its two sines are parts of. */
function limbGain(): number {
  const { packed } = smallTree();
  const texels = swayTexels(packed, STILL.sway);
  return (texels.data[layerStart(texels, SWAY_LAYERS.GAIN) + 4 * longLimb(packed) + 1] ?? 0) / RADIANS;
}

/** A square about the middle, half as wide as it is said. */
const square = (half: number): readonly Point[] => [
  [-half, -half],
  [half, -half],
  [half, half],
  [-half, half],
  [-half, -half],
];

/** The edge of a picture that shows so many degrees: one of a few, so that small changes are seen as such. */
const edgeFor = (degrees: number): number =>
  5 * 2 ** (Math.ceil(2 * Math.log2((1.1 * Math.max(4.5, degrees)) / 5)) / 2);

class Sway extends PlaneFigure {
  readonly #trace: Plane;
  readonly #gain = limbGain();
  /** Degrees from the middle of the picture to its edge. */
  #edge = 0;

  constructor(host: FigureHost) {
    super(host);
    this.#trace = new Plane(host);
  }

  draw(values: Values, time: number): Record<string, string> {
    const { size } = this.host;
    const { answer, wrong, line, soft, rest, force } = this.host.colours();
    const settings = settingsOf(values);
    const printed = choiceOf(values, 'rate') === 'printed';
    const colour = printed ? wrong : answer;
    const swing = limbSwing(settings);
    const steps = 1500;
    const path = Array.from({ length: steps + 1 }, (_, i) => swing(time - PAST * (1 - i / steps)));
    // As far as it could go with either rate; a scale that followed the drag would run away from the pointer.
    const [quick, both] = this.#amplitudes(values);
    if (!this.host.held) this.#edge = edgeFor(both);
    const edge = this.#edge;
    const ring = niceStep(edge, 3);
    const [left, right] = [{ x: [0, 0.45] }, { x: [0.45, 1] }] as const;
    const plane = this.plane;
    plane.begin({ x: [-edge, edge], y: [-edge, edge], equal: true, margin: marginsOf(size, left) });
    for (const radius of [ring, 2 * ring]) plane.circle([0, 0], radius, { colour: line, width: 1, alpha: 0.5 });
    plane.dot([0, 0], 3, { colour: rest });
    const now = path.at(-1);
    plane.clipped(() => {
      for (let i = 1; i < path.length; i++) {
        const [a, b] = [path[i - 1], path[i]];
        if (a && b) plane.line(a, b, { colour, width: 1.8, alpha: 0.08 + 0.75 * (i / steps) ** 3 });
      }
      if (now) plane.dot(now, 6, { colour });
      for (const half of [quick, both]) plane.polyline(square(half), { colour: force, width: 1, dash: [3, 4] });
    });
    for (const radius of [ring, 2 * ring])
      plane.text([0, radius], `${radius}°`, { size: 12, colour: soft, align: 'center', shift: [0, -3] });
    const named = { colour: force, size: 13, italic: true } as const;
    plane.text([quick, 0], 'a₁', { ...named, shift: [12, -8] });
    plane.text([0, -both], 'a₁ + a₂', { ...named, align: 'right', shift: [-14, -8] });
    const trace = this.#trace;
    const span = 20;
    trace.begin(
      { x: [-span, 0], y: [-edge, edge], margin: marginsOf(size, right, { left: 48, bottom: 44, top: 16, right: 14 }) },
      { keep: true },
    );
    trace.grid(5, ring);
    trace.axes({ y: 'swing, degrees' }, 5, ring);
    trace.text([0, -edge], 'seconds ago', { size: 12, align: 'right', baseline: 'top', shift: [0, 22] });
    trace.clipped(() => {
      trace.graph((t) => swing(time + t)[0], { colour, width: 2.2 });
      trace.graph((t) => swing(time + t)[1], { colour, width: 1.6, dash: [6, 4] });
    });
    const { mechanics } = smallTree().packed;
    const at = MECHANICS_SIZE * longLimb(smallTree().packed);
    const omega = swayRate(settings, mechanics[at + MECHANICS.RADIUS] ?? 0, mechanics[at + MECHANICS.LENGTH] ?? 1);
    const far = path.reduce((most, [x, y]) => Math.max(most, Math.hypot(x - (now?.[0] ?? 0), y - (now?.[1] ?? 0))), 0);
    return { period: ((2 * Math.PI) / omega).toFixed(omega > 0.05 ? 2 : 0), moved: far.toFixed(1) };
  }

  /** The edges of the two squares: as far as the quick sine goes, by the wind speed, and as far as both go, by the gust. */
  handles(values: Values) {
    const [speed, gust] = [numberOf(values, 'speed'), numberOf(values, 'gust')];
    const [quick, both] = this.#amplitudes(values);
    const colour = this.host.colours().force;
    const within = (x: number, y: number): Point => this.plane.within([x, y]);
    return [
      this.plane.handle({
        id: 'speed',
        label: 'Wind speed, by how far the quick sine goes',
        at: [quick, 0],
        ways: 'across',
        colour,
        said: `${speed}, ${quick.toFixed(1)} degrees`,
        move: (x) => this.host.set('speed', (50 * within(x, 0)[0]) / this.#gain),
      }),
      this.plane.handle({
        id: 'gust',
        label: 'Gust, by how far both sines go',
        at: [0, -both],
        ways: 'up',
        colour,
        said: `${gust}, ${both.toFixed(1)} degrees`,
        move: (_, y) => this.host.set('gust', (-50 * within(0, y)[1]) / this.#gain - 1.5 * speed),
      }),
    ];
  }

  /** How far the quick sine goes along one axis, and both together: degrees. */
  #amplitudes(values: Values): readonly [quick: number, both: number] {
    const [quick, slow] = swayParts(numberOf(values, 'speed'), numberOf(values, 'gust'));
    return [quick * this.#gain, (quick + slow) * this.#gain];
  }

  text(values: Values): string {
    return choiceOf(values, 'rate') === 'printed'
      ? 'With the printed rate the limb hardly moves within two minutes.'
      : 'The tip of the limb runs along a Lissajous figure.';
  }
}

/** The sway of 1995: a Lissajous figure, at the printed rate and at ours. */
export const sway: FigureSpec = {
  id: 'sway',
  title: 'Two sines about two axes',
  aspect: 1.75,
  moves: true,
  begin: PAST,
  controls: [
    {
      id: 'rate',
      label: 'Rate',
      value: 'ours',
      options: [
        { value: 'ours', label: '67 r/L, ours' },
        { value: 'printed', label: 'r/L / 15, as printed' },
      ],
    },
    { id: 'speed', label: 'Wind speed s', min: 0, max: 10, step: 0.1, value: 2 },
    { id: 'gust', label: 'Gust g', min: 0, max: 10, step: 0.1, value: 1 },
  ],
  readouts: [
    { id: 'period', label: 'Period of the quick sine', unit: 's' },
    { id: 'moved', label: 'Farthest way in two minutes', unit: '°' },
  ],
  open: (values) => smallTreeLink({ ...STILL, name: 'Sway', model: 'sway', sway: settingsOf(values) }),
  stage: (host) => new Sway(host),
};
