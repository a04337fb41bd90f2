import { PIECE_LAYERS } from '../../core/pack/layout.ts';
import type { PackedTree } from '../../core/pack/packed.ts';
import { layerStart } from '../../core/pack/texel-array.ts';
import { choiceOf, type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { depthOf } from './lag-run.ts';
import { smallTree } from './small-tree.ts';
import { TexelGrid } from './texel-grid.ts';

/** Rows between the two sets, for the lines. */
const GAP = 4;

/** The last pass. */
const MOST = 3;

class Passes extends PlaneFigure {
  readonly #tree: PackedTree;
  readonly #sets: readonly [TexelGrid, TexelGrid];

  constructor(host: FigureHost) {
    super(host);
    this.#tree = smallTree().packed;
    const { width, height } = this.#tree.pieces;
    this.#sets = [new TexelGrid(width, height, 0, 2 * height + GAP), new TexelGrid(width, height, 0, height)];
  }

  draw(values: Values): Record<string, string> {
    const plane = this.plane;
    const tree = this.#tree;
    const { width, height } = tree.pieces;
    const exact = choiceOf(values, 'way') === 'exact';
    const pass = numberOf(values, 'pass');
    plane.begin({ x: [-0.4, width + 0.4], y: [-3, 2 * height + GAP + 1.6], equal: true });
    const names = exact
      ? ['even depths', 'odd depths']
      : pass % 2 === 0
        ? ['read: the step before', 'written: this step']
        : ['written: this step', 'read: the step before'];
    const { hairline, force, level0, level1, level2, level3, line, soft } = this.host.colours();
    const levels = [level0, level1, level2, level3];
    const written = (piece: number, set: number): boolean =>
      exact ? depthOf(tree, piece) === pass && set === pass % 2 : set === 1 - (pass % 2);
    const filled = (piece: number, set: number): boolean => {
      const depth = depthOf(tree, piece);
      return exact ? depth < pass && depth % 2 === set : set === pass % 2;
    };
    this.#sets.forEach((grid, set) => {
      for (let i = 0; i < width * height; i++) {
        const there = i < tree.pieceCount;
        const depth = there ? depthOf(tree, i) : 0;
        if (there && written(i, set)) grid.cell(plane, i, force);
        else if (there && filled(i, set)) grid.cell(plane, i, levels[Math.min(depth, 3)] ?? line);
        else grid.cell(plane, i, hairline, there ? 0.9 : 0.35);
      }
    });
    const links = this.#links(exact ? pass : null, exact ? pass % 2 : 1 - (pass % 2));
    for (const [from, to] of links) plane.line(from, to, { colour: force, width: 1, alpha: exact ? 0.7 : 0.35 });
    // Over the lines.
    this.#sets.forEach((grid, set) => {
      plane.text([grid.x, grid.y], names[set] ?? '', { size: 13, colour: soft, shift: [0, -8] });
    });
    plane.line(this.#stop(0), this.#stop(MOST), { colour: line, width: 1 });
    for (let n = 0; n <= MOST; n++) {
      plane.dot(this.#stop(n), 3, { colour: line });
      plane.text(this.#stop(n), `pass ${n}`, {
        colour: soft,
        size: 12,
        align: 'center',
        baseline: 'top',
        shift: [0, 12],
      });
    }
    const count = exact ? (tree.depthStart[pass + 1] ?? 0) - (tree.depthStart[pass] ?? 0) : tree.pieceCount;
    const depths = tree.depthStart.length - 1;
    return {
      depths: String(depths),
      written: String(count),
      draws: exact ? String(depths) : '1',
      late: exact ? '0' : `1 to ${depths - 1}`,
    };
  }

  handles(values: Values) {
    const pass = numberOf(values, 'pass');
    return [
      this.plane.handle({
        id: 'pass',
        label: 'Pass',
        at: this.#stop(pass),
        ways: 'across',
        said: `pass ${pass}`,
        move: (x) => this.host.set('pass', (x - this.#stop(0)[0]) / (this.#stop(1)[0] - this.#stop(0)[0])),
        turn: (steps) => this.host.set('pass', pass + steps),
      }),
    ];
  }

  /** Where a pass stands on the line below the sets. */
  #stop(pass: number): Point {
    const { width } = this.#tree.pieces;
    return [width * (0.14 + (0.72 * pass) / MOST), -1.4];
  }

  text(values: Values): string {
    return choiceOf(values, 'way') === 'exact'
      ? `Pass ${numberOf(values, 'pass')} writes one depth into one set and reads its parents from the other.`
      : 'All texels of one set are written at once; parents are read from the other, as they were a step ago.';
  }

  /** From each parent's texel in the set that is read to its child's in the one that is written. */
  #links(depth: number | null, into: number): [Point, Point][] {
    const { pieces, pieceCount } = this.#tree;
    const attach = layerStart(pieces, PIECE_LAYERS.ATTACH);
    const [target, source] = [this.#sets[into === 0 ? 0 : 1], this.#sets[into === 0 ? 1 : 0]];
    const out: [Point, Point][] = [];
    for (let i = 0; i < pieceCount; i++) {
      const parent = pieces.data[attach + 4 * i] ?? -1;
      if (parent < 0 || (depth !== null && depthOf(this.#tree, i) !== depth)) continue;
      out.push([source.at(parent), target.at(i)]);
    }
    return out;
  }
}

/** The two sets of textures while a frame is computed. */
export const passes: FigureSpec = {
  id: 'passes',
  title: 'Two sets, pass by pass',
  aspect: 1.3,
  controls: [
    {
      id: 'way',
      label: 'Way',
      value: 'exact',
      options: [
        { value: 'exact', label: 'Depth by depth' },
        { value: 'lagged', label: 'The paper’s' },
      ],
    },
    { id: 'pass', label: 'Pass', min: 0, max: MOST, step: 1, value: 2 },
  ],
  readouts: [
    { id: 'depths', label: 'Depths of the tree' },
    { id: 'written', label: 'Texels written by this pass' },
    { id: 'draws', label: 'Draw calls a frame' },
    { id: 'late', label: 'Parents are late by, steps' },
  ],
  stage: (host) => new Passes(host),
};
