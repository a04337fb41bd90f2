import { POSE_TARGETS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { createWindState, windStateAt } from '../../core/wind/fade.ts';
import { poseTree } from '../../core/wind/pose-tree.ts';
import { choiceOf, type FigureHost, type FigureSpec, type FigureStage, numberOf, type Values } from '../figure.ts';
import { marginsOf } from '../panels.ts';
import { Plane } from '../plane.ts';
import { signed } from '../signed.ts';
import { someWaves, windOf } from '../sum-of-sines/waves.ts';
import { smallTree } from './small-tree.ts';
import { TexelGrid } from './texel-grid.ts';
import { TreeDrawing } from './tree-drawing.ts';

/** Metres of displacement from rest that go from middle grey to full colour. */
const MOVED = 0.35;

class Textures implements FigureStage {
  readonly #host: FigureHost;
  readonly #tree: PackedTree;
  readonly #drawing: TreeDrawing;
  readonly #branches: Plane;
  readonly #sheet: Plane;
  readonly #grids: TexelGrid[];
  readonly #state = createWindState();
  readonly #pose: Float32Array;

  constructor(host: FigureHost) {
    this.#host = host;
    this.#tree = smallTree().packed;
    this.#drawing = new TreeDrawing(this.#tree);
    this.#branches = new Plane(host);
    this.#sheet = new Plane(host);
    const { width, height, data } = this.#tree.restPose;
    this.#pose = new Float32Array(data.length);
    this.#grids = [0, 1, 2, 3].map((k) => new TexelGrid(width, height, 0, 4 * (height + 1) - k * (height + 1) - 1));
    for (const event of ['pointerdown', 'pointermove'] as const)
      host.canvas.addEventListener(event, (e) => this.#point(e.offsetX, e.offsetY));
  }

  draw(values: Values, time: number): Record<string, string> {
    const host = this.#host;
    const tree = this.#tree;
    const chosen = numberOf(values, 'piece');
    const wind = windOf(someWaves(4, 2.2, 0.3, 1), {
      strength: 1,
      lengthExponent: 0.6,
      stiffness: 1 / numberOf(values, 'strength'),
    });
    poseTree(tree, windStateAt(wind, time, undefined, this.#state), 'exact', undefined, this.#pose);
    this.#branches.begin({
      x: [-1.7, 1.9],
      y: [-0.1, 6.2],
      equal: true,
      margin: marginsOf(host.size, { x: [0, 0.42] }),
    });
    this.#ground();
    const colours = host.colours();
    this.#drawing.draw(this.#branches, this.#pose, colours, (piece) =>
      piece === chosen ? { colour: colours.force, wider: 4 } : { alpha: 0.85 },
    );
    this.#points(chosen, colours.ink);
    const { width, height } = tree.restPose;
    const rows = 4 * (height + 1);
    this.#sheet.begin(
      { x: [-2, width], y: [-0.2, rows], equal: true, margin: marginsOf(host.size, { x: [0.42, 1] }) },
      { keep: true },
    );
    this.#texels(choiceOf(values, 'show') === 'moved', chosen);
    return this.#numbers(chosen);
  }

  text(values: Values): string {
    const piece = numberOf(values, 'piece');
    return `Texel ${piece} is a branch of level ${this.#drawing.level(piece)}. ${this.#tree.pieceCount} texels hold the whole tree.`;
  }

  #point(px: number, py: number): void {
    const { pieceCount } = this.#tree;
    const texel = Math.max(...this.#grids.map((grid) => grid.pick(this.#sheet, px, py)));
    const piece = texel >= 0 && texel < pieceCount ? texel : this.#drawing.pick(this.#branches, this.#pose, px, py);
    if (piece >= 0) this.#host.set('piece', piece);
  }

  #ground(): void {
    const { line } = this.#host.colours();
    this.#branches.line([this.#branches.x[0], 0], [this.#branches.x[1], 0], { colour: line, width: 1 });
  }

  /** The control points of a piece, and their polygon. */
  #points(piece: number, colour: string): void {
    const plane = layerStart(this.#tree.restPose, 1);
    const points = [0, 1, 2, 3].map((k) => {
      const at = k * plane + 4 * piece;
      return this.#drawing.flat([this.#pose[at] ?? 0, this.#pose[at + 1] ?? 0, this.#pose[at + 2] ?? 0]);
    });
    this.#branches.polyline(points, { colour, width: 1, dash: [3, 3] });
    for (const point of points) this.#branches.dot(point, 3, { colour });
  }

  #texels(moved: boolean, chosen: number): void {
    const { restPose, pieceCount, bounds } = this.#tree;
    const plane = layerStart(restPose, 1);
    const { ink, hairline, force } = this.#host.colours();
    const low = [0, 1, 2].map((k) => bounds[k] ?? 0);
    const size = [0, 1, 2].map((k) => (bounds[3 + k] ?? 1) - (low[k] ?? 0));
    this.#grids.forEach((grid, target) => {
      const [x, y] = grid.at(0);
      this.#sheet.text([x - 0.9, y - 0.5], `P${'₀₁₂₃'[target]}`, {
        align: 'right',
        baseline: 'middle',
        size: 15,
        italic: true,
      });
      for (let i = 0; i < grid.width * grid.height; i++) {
        if (i >= pieceCount) {
          grid.cell(this.#sheet, i, hairline, 0.4);
          continue;
        }
        const at = target * plane + 4 * i;
        const rgb = [0, 1, 2].map((k) => {
          const value = this.#pose[at + k] ?? 0;
          const part = moved
            ? 0.5 + (0.5 * (value - (restPose.data[at + k] ?? 0))) / MOVED
            : (value - (low[k] ?? 0)) / (size[k] ?? 1);
          return Math.round(255 * Math.min(1, Math.max(0, part)));
        });
        grid.cell(this.#sheet, i, `rgb(${rgb.join()})`);
      }
      grid.outline(this.#sheet, chosen, ink, 4);
      grid.outline(this.#sheet, chosen, force, 2);
    });
  }

  #numbers(piece: number): Record<string, string> {
    const plane = layerStart(this.#tree.restPose, 1);
    return Object.fromEntries(
      Object.values(POSE_TARGETS).map((target) => {
        const at = target * plane + 4 * piece;
        return [`p${target}`, [0, 1, 2].map((k) => signed(this.#pose[at + k] ?? 0, 2)).join('  ')];
      }),
    );
  }
}

/** The pose textures of a small tree, live. */
export const textures: FigureSpec = {
  id: 'textures',
  title: 'A tree as four textures',
  aspect: 1.55,
  moves: true,
  begin: 41,
  controls: [
    { id: 'piece', label: 'Texel', min: 0, max: 57, step: 1, value: 9 },
    {
      id: 'show',
      label: 'Colours show',
      value: 'place',
      options: [
        { value: 'place', label: 'where points are' },
        { value: 'moved', label: 'how far the wind moved them' },
      ],
    },
    { id: 'strength', label: 'Softness of the tree', min: 0, max: 4, step: 0.1, value: 2 },
  ],
  readouts: [0, 1, 2, 3].map((k) => ({ id: `p${k}`, label: `P${'₀₁₂₃'[k]}: x, y, z`, unit: 'm' })),
  open: () => 's=quaking-aspen&seed=1&view=levels',
  stage: (host) => new Textures(host),
};
