import { distance } from '../../core/math/vec3.ts';
import { TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { planeOf, poseOf } from '../../core/wind/pose-plainly.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import { STEP } from '../../gpu/step.ts';
import { choiceOf, type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf, type Part } from '../panels.ts';
import { Plane } from '../plane.ts';
import { signed } from '../signed.ts';
import { depthOf } from './lag-run.ts';
import { type LivePose, poseIn, type TwoSets } from './live-pose.ts';
import { LATE, SetsDrawing } from './sets-drawing.ts';
import { smallTree } from './small-tree.ts';
import { smallTreeLink } from './small-tree-link.ts';
import { BREEZE, StruckWind } from './struck-wind.ts';
import { TreeDrawing } from './tree-drawing.ts';
import { twinPose } from './twin-pose.ts';

const WORDS = {
  shader: 'the wind pass, on the GPU',
  twin: 'its twin in TypeScript: here nothing can draw into float textures',
} as const;

/** What the textures held at a moment, and where all should have been. */
interface Seen {
  readonly two: TwoSets;
  readonly pose: Float32Array;
  readonly exact: Float32Array;
  readonly step: number | null;
  readonly what: string;
}

const wayOf = (values: Values) => (choiceOf(values, 'way') === 'lagged' ? 'lagged' : 'exact');

class Textures implements FigureStage {
  readonly ready: Promise<void>;
  readonly #host: FigureHost;
  readonly #tree: PackedTree;
  readonly #wind: StruckWind;
  readonly #drawing: TreeDrawing;
  readonly #branches: Plane;
  readonly #sets: SetsDrawing;
  #source: LivePose | null = null;
  #seen: Seen | null = null;
  #waits = false;
  #failed: unknown = null;
  #tell: () => void = () => {};
  /** Steps since the blow, while the reader steps, and the figure's time then. */
  #step: number | null = null;
  #stopped = 0;
  #time = 0;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#tree = smallTree().packed;
    this.#wind = new StruckWind(this.#tree.depthStart.length);
    this.#drawing = new TreeDrawing(this.#tree);
    this.#branches = new Plane(host);
    this.#sets = new SetsDrawing(host, this.#tree);
    this.ready = new Promise((keep) => {
      this.#tell = keep;
    });
    void this.#begin();
    for (const event of ['pointerdown', 'pointermove'] as const)
      host.canvas.addEventListener(event, (e) => this.#point(e.offsetX, e.offsetY));
  }

  draw(values: Values, time: number): Record<string, string> {
    if (this.#failed) throw this.#failed;
    // Who plays on has done with stepping.
    if (this.#step !== null && time !== this.#stopped) this.#step = null;
    this.#time = time;
    this.#ask(wayOf(values));
    const seen = this.#seen;
    if (!seen) return {};
    const chosen = numberOf(values, 'piece');
    const { size } = this.#host;
    const wide = size.width > 560;
    const tree: Part = wide ? { x: [0, 0.36] } : { y: [0, 0.5] };
    const sheet: Part = wide ? { x: [0.36, 1] } : { y: [0.5, 1] };
    const late = this.#late(seen);
    this.#branches.begin({ x: [-1.7, 2.5], y: [-0.1, 6.4], equal: true, margin: marginsOf(size, tree) });
    this.#draw(seen, chosen, late);
    this.#sets.draw(sheet, {
      two: seen.two,
      step: seen.step,
      moved: choiceOf(values, 'show') === 'moved',
      chosen,
      late,
    });
    return this.#numbers(seen, chosen, late);
  }

  step(): void {
    this.#step = this.#step === null ? 0 : this.#step + 1;
    this.#stopped = this.#time;
    this.#host.redraw();
  }

  reset(): void {
    this.#step = null;
  }

  handles(values: Values) {
    const seen = this.#seen;
    if (!seen) return [];
    const piece = numberOf(values, 'piece');
    const { p3 } = poseOf(seen.pose, planeOf(this.#tree.restPose), piece).curve;
    const [x, y] = this.#branches.toPixel(...this.#drawing.flat(p3));
    return [
      {
        id: 'piece',
        label: 'The chosen branch',
        x,
        y,
        colour: this.#host.colours().force,
        said: `texel ${piece}`,
        move: (px: number, py: number) => {
          const under = this.#drawing.pick(this.#branches, seen.pose, px, py);
          if (under >= 0) this.#host.set('piece', under);
        },
        turn: (steps: number) => this.#host.set('piece', piece + steps),
      },
    ];
  }

  text(values: Values): string {
    const piece = numberOf(values, 'piece');
    const { pieceCount } = this.#tree;
    const seen = this.#seen;
    const late = seen ? [...this.#late(seen)].filter((metres) => metres > LATE).length : 0;
    const stepped = seen?.step == null ? '' : ` Step ${seen.step}: ${late} texels are not yet where they should be.`;
    return `Texel ${piece} is a piece of depth ${depthOf(this.#tree, piece)}. ${pieceCount} texels hold the whole tree.${stepped}`;
  }

  dispose(): void {
    this.#source?.dispose();
  }

  async #begin(): Promise<void> {
    try {
      // Large: the figures below draw meanwhile.
      const { shaderPose } = await import('./shader-pose.ts');
      this.#source = shaderPose(this.#tree, () => this.#host.redraw()) ?? twinPose(this.#tree);
    } catch (error) {
      this.#failed = error;
    }
    this.#host.redraw();
  }

  /** Poses the tree for now, once what was asked for before has come. */
  #ask(way: 'exact' | 'lagged'): void {
    const source = this.#source;
    const wind = this.#wind;
    wind.struck = this.#step !== null;
    wind.pose = way;
    const step = this.#step;
    const time = step === null ? this.#time : step * STEP;
    const what = `${way} ${wind.revision} ${time}`;
    if (!source || this.#waits || this.#seen?.what === what) return;
    this.#waits = true;
    const state = wind.at(way === 'lagged' ? Math.round(time / STEP) * STEP : time);
    source
      .run(time, wind)
      .then((two) => {
        if (!two) return;
        const exact = poseTree(this.#tree, state, 'exact');
        this.#seen = { two, pose: poseIn(this.#tree, two), exact, step, what };
        this.#tell();
        this.#host.redraw();
      })
      .catch((error: unknown) => {
        this.#failed = error;
        this.#host.redraw();
      })
      .finally(() => {
        this.#waits = false;
      });
  }

  /** Metres from where the end of each piece should be. */
  #late({ pose, exact }: Seen): Float32Array {
    const plane = planeOf(this.#tree.restPose);
    return Float32Array.from({ length: this.#tree.pieceCount }, (_, i) =>
      distance(poseOf(pose, plane, i).curve.p3, poseOf(exact, plane, i).curve.p3),
    );
  }

  #point(px: number, py: number): void {
    const seen = this.#seen;
    if (!seen) return;
    const texel = this.#sets.pick(px, py);
    const piece = texel >= 0 ? texel : this.#drawing.pick(this.#branches, seen.pose, px, py);
    if (piece >= 0) this.#host.set('piece', piece);
  }

  #draw({ pose, exact, step }: Seen, chosen: number, late: Float32Array): void {
    const colours = this.#host.colours();
    const { line, rest, wrong, force, ink } = colours;
    const branches = this.#branches;
    branches.line([branches.x[0], 0], [branches.x[1], 0], { colour: line, width: 1 });
    if (step !== null) this.#drawing.draw(branches, exact, colours, () => ({ colour: rest, wider: 3, alpha: 0.4 }));
    const depths = [colours.level0, colours.level1, colours.level2, colours.level3];
    this.#drawing.draw(branches, pose, colours, (piece) => {
      if (piece === chosen) return { colour: force, wider: 4 };
      if (step !== null && (late[piece] ?? 0) > LATE) return { colour: wrong };
      return { colour: depths[Math.min(depthOf(this.#tree, piece), 3)] ?? ink };
    });
    const { p0, p1, p2, p3 } = poseOf(pose, planeOf(this.#tree.restPose), chosen).curve;
    const points = [p0, p1, p2, p3].map((point) => this.#drawing.flat(point));
    branches.polyline(points, { colour: ink, width: 1, dash: [3, 3] });
    for (const point of points) branches.dot(point, 3, { colour: ink });
  }

  #numbers({ pose, step }: Seen, piece: number, late: Float32Array): Record<string, string> {
    const plane = planeOf(this.#tree.restPose);
    const texel = (target: number, part: number): number => pose[target * plane + TEXEL * piece + part] ?? 0;
    const source = this.#source;
    return {
      ...Object.fromEntries(
        [0, 1, 2, 3].map((k) => [`p${k}`, [0, 1, 2].map((part) => signed(texel(k, part), 3)).join('\u2002')]),
      ),
      o: [0, 1, 2].map((k) => signed(texel(k, 3), 3)).join('\u2002'),
      off: `${(1000 * (late[piece] ?? 0)).toFixed(1)}`,
      step: step === null ? 'the wind blows' : `${step}: ${late.filter((metres) => metres > LATE).length} texels late`,
      by: source?.by === 'shader' ? WORDS.shader : WORDS.twin,
    };
  }
}

/** The pose textures of a small tree, as the wind pass writes them. */
export const textures: FigureSpec = {
  id: 'textures',
  title: 'A tree as four textures, twice',
  aspect: 1.3,
  narrow: 0.74,
  moves: true,
  steps: true,
  begin: 41,
  controls: [
    { id: 'piece', label: 'Texel', min: 0, max: 57, step: 1, value: 9 },
    {
      id: 'show',
      label: 'Colours show',
      value: 'place',
      options: [
        { value: 'place', label: 'where points are' },
        { value: 'moved', label: 'how far they moved' },
      ],
    },
    {
      id: 'way',
      label: 'The pass',
      value: 'lagged',
      options: [
        { value: 'lagged', label: 'paper: all at once' },
        { value: 'exact', label: 'ours: depth by depth' },
      ],
    },
  ],
  readouts: [
    ...[0, 1, 2, 3].map((k) => ({ id: `p${k}`, label: `P${'₀₁₂₃'[k]}`, unit: 'm' })),
    { id: 'o', label: 'O' },
    { id: 'off', label: 'Off by', unit: 'mm' },
    { id: 'step', label: 'Step' },
    { id: 'by', label: 'Computed by' },
  ],
  open: (values) => smallTreeLink({ ...BREEZE, pose: wayOf(values) }, 'levels'),
  stage: (host) => new Textures(host),
};
