import { POSE_TARGETS, TEXEL } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import type { FigureHost } from '../figure.ts';
import { marginsOf, type Part } from '../panels.ts';
import { Plane } from '../plane.ts';
import { depthOf } from './lag-run.ts';
import { setOf, type TwoSets } from './live-pose.ts';
import { TexelGrid } from './texel-grid.ts';

const TARGETS = Object.keys(POSE_TARGETS).length;
/** Metres of displacement from rest that go from middle grey to full colour. */
const MOVED = 0.35;
/** Metres that count as not in its place. */
export const LATE = 0.01;

/** What the two sets hold, and what of it is to be seen. */
export interface SetsShown {
  readonly two: TwoSets;
  /** Steps since the blow; null where the wind just blows. */
  readonly step: number | null;
  /** Colours are displacements from rest, in place of places. */
  readonly moved: boolean;
  /** The piece that is marked. */
  readonly chosen: number;
  /** Metres from where the end of each piece should be. */
  readonly late: Float32Array;
}

/** Two sets of four textures, drawn large beside each other, each texel a piece. */
export class SetsDrawing {
  readonly #host: FigureHost;
  readonly #tree: PackedTree;
  readonly #plane: Plane;
  readonly #grids: readonly (readonly TexelGrid[])[];
  readonly #depths: Uint8Array;

  constructor(host: FigureHost, tree: PackedTree) {
    this.#host = host;
    this.#tree = tree;
    this.#plane = new Plane(host);
    const { width, height } = tree.restPose;
    this.#grids = [0, 1].map((set) =>
      Array.from(
        { length: TARGETS },
        (_, target) => new TexelGrid(width, height, set * (width + 1), (TARGETS - target) * (height + 0.8) - 0.8),
      ),
    );
    this.#depths = Uint8Array.from({ length: tree.pieceCount }, (_, piece) => depthOf(tree, piece));
  }

  draw(part: Part, shown: SetsShown): void {
    const { width, height } = this.#tree.restPose;
    const plane = this.#plane;
    // Texels are a little higher than wide where there is room, and little enough where there is none.
    const air = part.y ? 28 : 0.11 * this.#host.size.height;
    plane.begin(
      {
        x: [-1.9, 2 * width + 1],
        y: [0, TARGETS * (height + 0.8)],
        margin: marginsOf(this.#host.size, part, { top: air, bottom: air, left: 4, right: 10 }),
      },
      { keep: true },
    );
    this.#grids.forEach((grids, set) => {
      this.#title(grids[0] as TexelGrid, set, shown);
      grids.forEach((grid, target) => {
        if (set === 0) this.#label(grid, `P${'₀₁₂₃'[target]}`);
        this.#texels(grid, set, target, shown);
      });
    });
    this.#legend();
  }

  /** The piece whose texel is under a pixel of the stage; -1: none. */
  pick(px: number, py: number): number {
    const texel = Math.max(...this.#grids.flat().map((grid) => grid.pick(this.#plane, px, py)));
    return texel < this.#tree.pieceCount ? texel : -1;
  }

  #label(grid: TexelGrid, name: string): void {
    const at = [grid.x, grid.y - grid.height / 2] as const;
    this.#plane.text(at, name, { align: 'right', baseline: 'middle', size: 15, italic: true, shift: [-6, 0] });
  }

  /** What the set is for, in this step. */
  #title(grid: TexelGrid, set: number, { two: { written }, step }: SetsShown): void {
    const { soft, force } = this.#host.colours();
    const now = step === null ? 'this step' : `step ${step}`;
    const before = step === null ? 'the step before' : step === 0 ? 'before the blow' : `step ${step - 1}`;
    const lagged = set === written ? `written: ${now}` : `read: ${before}`;
    const text = written === null ? ['even depths', 'odd depths'][set] : lagged;
    const colour = written === null || set === written ? force : soft;
    this.#plane.text([grid.x, grid.y], text ?? '', {
      colour,
      baseline: 'bottom',
      shift: [0, -7],
      bold: set === written,
    });
  }

  #texels(grid: TexelGrid, set: number, target: number, { two, moved, chosen, late }: SetsShown): void {
    const { restPose, pieceCount, bounds } = this.#tree;
    const { hairline, ink, force, wrong, paper, level0, level1, level2, level3 } = this.#host.colours();
    const levels = [level0, level1, level2, level3];
    const data = two.sets[set] as Float32Array;
    const plane = this.#plane;
    const layer = TEXEL * restPose.width * restPose.height;
    const channel = (at: number, k: number): number => {
      const value = data[at + k] ?? 0;
      const low = bounds[k] ?? 0;
      const part = moved
        ? 0.5 + (0.5 * (value - (restPose.data[at + k] ?? 0))) / MOVED
        : (value - low) / ((bounds[3 + k] ?? 1) - low);
      return Math.round(255 * Math.min(1, Math.max(0, part)));
    };
    for (let i = 0; i < grid.width * grid.height; i++) {
      if (i >= pieceCount) {
        grid.cell(plane, i, hairline, 0.4);
        continue;
      }
      const at = target * layer + TEXEL * i;
      // What is never read there is only hinted at.
      const used = two.written !== null || setOf(this.#tree, two, i) === set;
      grid.cell(plane, i, `rgb(${channel(at, 0)},${channel(at, 1)},${channel(at, 2)})`, used ? 1 : 0.12);
      grid.strip(plane, i, levels[Math.min(this.#depths[i] ?? 0, 3)] ?? ink, used ? 1 : 0.35);
      if ((late[i] ?? 0) > LATE && setOf(this.#tree, two, i) === set) {
        plane.dot(grid.at(i), 0.26 * plane.scale[0], { colour: paper });
        plane.dot(grid.at(i), 0.17 * plane.scale[0], { colour: wrong });
      }
    }
    grid.outline(plane, chosen, paper, 5);
    grid.outline(plane, chosen, force, 2.5);
  }

  #legend(): void {
    const { soft, wrong, level0, level1, level2, level3 } = this.#host.colours();
    const plane = this.#plane;
    const { y, height } = this.#grids.flat().at(-1) as TexelGrid;
    const names = ['depth 0', '1', '2', '3'];
    let x = 0;
    [level0, level1, level2, level3].forEach((colour, depth) => {
      const [px, py] = plane.toPixel(0, y - height);
      plane.context.fillStyle = colour;
      plane.context.fillRect(px + x, py + 15, 14, 5);
      const name = names[depth] ?? '';
      plane.text([0, y - height], name, { colour: soft, size: 12, baseline: 'middle', shift: [x + 19, 18] });
      x += 19 + 7 * name.length + 10;
    });
    plane.text([0, y - height], '● late', { colour: wrong, size: 12, baseline: 'middle', shift: [x + 4, 18] });
  }
}
