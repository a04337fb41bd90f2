import { MECHANICS, MECHANICS_SIZE } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { smallTree } from '../ping-pong/small-tree.ts';
import { smallTreeLink } from '../ping-pong/small-tree-link.ts';
import { TreeDrawing } from '../ping-pong/tree-drawing.ts';
import { Plane, type Point } from '../plane.ts';
import { GUST_START, gustWind, MODELS, ModelTree, traceOf } from './models.ts';

/** Seconds after which it begins anew. */
const LOOP = 10;
const SPLIT = 0.62;
/** Units of the picture that the arrow of a force of 1 m is long, and its height beside the trunk. */
const [PER_FORCE, ARROW] = [1.4, 0.8];
/** How far below the traces the ruler of the gust lies: a part of their scale. */
const RULER = -0.55;
const NAMES = { direct: 'direct', spring: 'spring', sway: 'sway' } as const;

/** The longest stem of level 1: its last piece. */
export function longLimb({ mechanics, pieceCount }: PackedTree): number {
  let [best, longest] = [0, 0];
  for (let i = 0; i < pieceCount; i++) {
    const at = MECHANICS_SIZE * i;
    const length = mechanics[at + MECHANICS.LENGTH] ?? 0;
    if (mechanics[at + MECHANICS.LEVEL] === 1 && (mechanics[at + MECHANICS.Z1] ?? 0) > 0.999 && length > longest)
      [best, longest] = [i, length];
  }
  return best;
}

interface Lane {
  readonly tree: ModelTree;
  readonly force: Float64Array;
  readonly moved: Float64Array;
}

const most = (trace: Float64Array): number => trace.reduce((a, v) => Math.max(a, Math.abs(v)), 0);

class Three implements FigureStage {
  readonly #host: FigureHost;
  readonly #tree: PackedTree;
  readonly #limb: number;
  readonly #drawing: TreeDrawing;
  readonly #planes: Plane[];
  readonly #traces: Plane[];
  #values: Values | null = null;
  #lanes: Lane[] = [];
  #scale = 1;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#tree = smallTree().packed;
    this.#limb = longLimb(this.#tree);
    this.#drawing = new TreeDrawing(this.#tree, 0);
    this.#planes = MODELS.map(() => new Plane(host));
    this.#traces = MODELS.map(() => new Plane(host));
  }

  draw(values: Values, time: number): Record<string, string> {
    if (values !== this.#values) this.#make(values);
    const now = time % LOOP;
    const { force, soft } = this.#host.colours();
    const scale = Math.max(...this.#lanes.map(({ moved }) => most(moved)), 0.02) * 1.15;
    this.#scale = scale;
    MODELS.forEach((model, i) => {
      const lane = this.#lanes[i];
      const [plane, trace] = [this.#planes[i], this.#traces[i]];
      if (!lane || !plane || !trace) return;
      this.#draw(plane, lane.tree.at(now), i, now);
      plane.text([(plane.x[0] + plane.x[1]) / 2, plane.y[1]], NAMES[model], {
        align: 'center',
        bold: true,
        size: 15,
        baseline: 'top',
      });
      this.#trace(trace, lane, i, now, scale);
      if (i === 0) {
        trace.text([0, scale], 'tip, m', { colour: soft, size: 12, baseline: 'bottom', shift: [0, -2] });
        const [from, to] = this.#strongest(values);
        plane.line(from, to, { colour: force, width: 1, dash: [3, 4] });
        const [begin, end] = this.#ruler(values);
        trace.line(begin, end, { colour: force, width: 1.5 });
        for (const [x, y] of [begin, end]) trace.line([x, 0], [x, y], { colour: force, width: 1, dash: [3, 4] });
      }
      if (i === 2)
        trace.text([LOOP, scale], 'force', {
          colour: force,
          size: 12,
          align: 'right',
          baseline: 'bottom',
          shift: [0, -2],
        });
    });
    const [direct, spring, sway] = this.#lanes.map(({ moved }) => most(moved));
    return {
      direct: (100 * (direct ?? 0)).toFixed(1),
      spring: (100 * (spring ?? 0)).toFixed(1),
      sway: (100 * (sway ?? 0)).toFixed(1),
      late: this.#late().toFixed(2),
    };
  }

  text(): string {
    const [direct, spring, sway] = this.#lanes.map(({ moved }) => (100 * most(moved)).toFixed(0));
    return `The gust moves the tip by at most ${direct} centimetres at once, ${spring} as a spring; the swaying limb goes up to ${sway}, gust or none.`;
  }

  handles(values: Values) {
    const [plane, trace] = [this.#planes[0], this.#traces[0]];
    if (!plane || !trace) return [];
    const { force } = this.#host.colours();
    const rise = numberOf(values, 'rise');
    const [foot, tip] = this.#strongest(values);
    return [
      plane.handle({
        id: 'gust',
        label: 'Strength of the gust',
        at: tip,
        ways: 'across',
        colour: force,
        said: `${numberOf(values, 'gust')} metres`,
        move: (x) => this.#host.set('gust', (x - foot[0]) / PER_FORCE),
      }),
      trace.handle({
        id: 'rise',
        label: 'End of the gust',
        at: this.#ruler(values)[1],
        ways: 'across',
        colour: force,
        said: `${(GUST_START + 2 * rise).toFixed(1)} seconds`,
        move: (x) => this.#host.set('rise', (x - GUST_START) / 2),
      }),
    ];
  }

  /** The arrow of the gust at its strongest: its foot and its tip. */
  #strongest(values: Values): readonly [Point, Point] {
    const foot = this.#foot(this.#planes[0] as Plane);
    return [foot, [foot[0] + PER_FORCE * numberOf(values, 'gust'), ARROW]];
  }

  /** Where an arrow begins, at the edge of its picture. */
  #foot(plane: Plane): Point {
    return [plane.x[0] + 0.15, ARROW];
  }

  /** From the begin of the gust to its end, below its trace. */
  #ruler(values: Values): readonly [Point, Point] {
    const y = RULER * this.#scale;
    return [
      [GUST_START, y],
      [GUST_START + 2 * numberOf(values, 'rise'), y],
    ];
  }

  #make(values: Values): void {
    this.#values = values;
    this.#lanes = MODELS.map((model) => {
      const wind = gustWind(model, numberOf(values, 'gust'), numberOf(values, 'rise'), numberOf(values, 'damping'));
      return { tree: new ModelTree(this.#tree, wind), ...traceOf(this.#tree, this.#limb, wind, LOOP) };
    });
  }

  /** Seconds between the highest of the direct trace and that of the spring. */
  #late(): number {
    const peak = (trace: Float64Array | undefined): number => {
      if (!trace) return 0;
      let best = 0;
      trace.forEach((v, i) => {
        if (v > (trace[best] ?? 0)) best = i;
      });
      return best / 60;
    };
    return peak(this.#lanes[1]?.moved) - peak(this.#lanes[0]?.moved);
  }

  #draw(plane: Plane, pose: Float32Array, column: number, now: number): void {
    const { size } = this.#host;
    const margin = marginsOf(size, { x: [column / 3, (column + 1) / 3], y: [0, SPLIT] }, { bottom: 4 });
    plane.begin({ x: [-1.9, 2.4], y: [-0.1, 6.6], equal: true, margin }, { keep: column > 0 });
    const colours = this.#host.colours();
    plane.line([-1.9, 0], [2.4, 0], { colour: colours.line, width: 1 });
    this.#drawing.draw(plane, this.#tree.restPose.data, colours, () => ({ colour: colours.rest, alpha: 0.25 }));
    this.#drawing.draw(plane, pose, colours, (piece) =>
      piece === this.#limb ? { colour: colours.ink, wider: 2.5 } : { colour: colours.answer, alpha: 0.85 },
    );
    const force = this.#lanes[column]?.force[Math.min(60 * LOOP - 1, Math.floor(60 * now))] ?? 0;
    if (force > 1e-3)
      plane.arrow(this.#foot(plane), [this.#foot(plane)[0] + PER_FORCE * force, ARROW], {
        colour: colours.force,
        width: 3,
      });
  }

  #trace(plane: Plane, { force, moved }: Lane, column: number, now: number, scale: number): void {
    const { size } = this.#host;
    const left = column === 0 ? 40 : 14;
    const margin = marginsOf(
      size,
      { x: [column / 3, (column + 1) / 3], y: [SPLIT, 1] },
      { top: 24, bottom: 26, left, right: 10 },
    );
    plane.begin({ x: [0, LOOP], y: [-scale, scale], margin }, { keep: true });
    const colours = this.#host.colours();
    const step = scale > 0.5 ? 0.5 : scale > 0.2 ? 0.2 : 0.1;
    for (const y of [-step, 0, step]) {
      plane.line([0, y], [LOOP, y], { colour: y === 0 ? colours.line : colours.hairline, width: 1 });
      if (column === 0)
        plane.text([0, y], String(y).replace('-', '−'), {
          size: 12,
          colour: colours.soft,
          align: 'right',
          baseline: 'middle',
          shift: [-6, 0],
        });
    }
    // On a narrow sheet there is room for the ends alone.
    for (let s = 0; s <= LOOP; s += size.width > 520 ? 5 : LOOP)
      plane.text([s, -scale], `${s} s`, {
        size: 12,
        colour: colours.soft,
        align: 'center',
        baseline: 'top',
        shift: [s === 0 ? 8 : s === LOOP ? -8 : 0, 6],
      });
    const points = (of: Float64Array, factor = 1): Point[] => Array.from(of, (v, i): Point => [i / 60, v * factor]);
    // The force on a scale of its own: its shape is what matters.
    const factor = (0.75 * scale) / Math.max(0.05, most(force));
    plane.area([[0, 0], ...points(force, factor), [LOOP, 0]], { colour: colours.force, alpha: 0.14 });
    plane.polyline(points(force, factor), { colour: colours.force, width: 1.2 });
    const upTo = Math.max(2, Math.floor(60 * now));
    plane.polyline(points(moved), { colour: colours.answer, width: 1.2, alpha: 0.4 });
    plane.polyline(points(moved).slice(0, upTo), { colour: colours.answer, width: 2.4 });
    const at = moved[upTo - 1] ?? 0;
    plane.dot([upTo / 60, at], 4, { colour: colours.answer });
  }
}

/** The same gust on the same tree, three times. */
export const three: FigureSpec = {
  id: 'three',
  title: 'One gust, three models',
  aspect: 1.45,
  moves: true,
  begin: GUST_START + 0.95,
  controls: [
    { id: 'gust', label: 'Gust', unit: 'm', min: 0.05, max: 1.5, step: 0.05, value: 0.7 },
    { id: 'rise', label: 'Rise and fall, each', unit: 's', min: 0.1, max: 3, step: 0.1, value: 0.6 },
    { id: 'damping', label: 'Damping ζ', min: 0.02, max: 1.2, step: 0.01, value: 0.12 },
  ],
  readouts: [
    { id: 'direct', label: 'Direct goes', unit: 'cm' },
    { id: 'spring', label: 'Spring goes', unit: 'cm' },
    { id: 'sway', label: 'Sway goes', unit: 'cm' },
    { id: 'late', label: 'Spring comes later by', unit: 's' },
  ],
  open: (values) =>
    smallTreeLink(gustWind('spring', numberOf(values, 'gust'), numberOf(values, 'rise'), numberOf(values, 'damping'))),
  stage: (host) => new Three(host),
};
