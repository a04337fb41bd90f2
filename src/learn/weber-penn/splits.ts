import { splitSequence } from '../../core/grow/splits.ts';
import type { Tree } from '../../core/grow/tree.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies, editorLink } from './changed-species.ts';
import { sketchTree } from './sketch.ts';

/** Metres of the trunk. */
const HEIGHT = 13;

const changes = (values: Values): Changes => ({
  tree: { scaleV: 0, levels: 1, ratio: 0.02, lobeDepth: 0 },
  levels: {
    0: {
      curveRes: numberOf(values, 'res'),
      curveV: 0,
      segSplits: numberOf(values, 'splits'),
      splitAngle: numberOf(values, 'angle'),
      taper: 0.9,
    },
  },
  leaves: { count: 0 },
});

/** The turn of the view that lays the first clone's first segment into the plane of the screen. */
function firstFork({ count, clone, nodeStart, nodePosition }: Tree['stems']): number {
  for (let i = 0; i < count; i++) {
    if (clone[i] !== 1) continue;
    const n = 3 * (nodeStart[i] as number);
    const along = (k: number): number => (nodePosition[n + 3 + k] as number) - (nodePosition[n + k] as number);
    return -Math.atan2(along(1), along(0));
  }
  return 0;
}

class Splits extends AspenFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-8, 8], y: [-0.4, 13.4], equal: true });
    p.line([p.x[0], 0], [p.x[1], 0], { colour: c.line, width: 1 });
    const tree = this.grow(JSON.stringify(values), () => changedSpecies(this.aspen, changes(values)), 2);
    const { stems } = tree;
    // Seen from where the first fork opens to the right: so its angle is that on the screen.
    const turn = firstFork(tree.stems);
    sketchTree(p, tree, { colours: c, turn });
    for (let i = 0; i < stems.count; i++) {
      if (stems.clone[i] !== 1) continue;
      const n = 3 * (stems.nodeStart[i] as number);
      const [x, y, z] = stems.nodePosition.subarray(n, n + 3) as unknown as [number, number, number];
      p.dot([x * Math.cos(turn) - y * Math.sin(turn), z], 3.5, { colour: c.force });
    }
    const [tip, fork] = this.#angle(values);
    p.line(fork, tip, { colour: c.answer, width: 1, dash: [4, 4] });
    const sequence = splitSequence(numberOf(values, 'splits'), Math.max(0, numberOf(values, 'res') - 1));
    return {
      stems: String(stems.count),
      sequence: sequence.join(', ') || 'none',
      formula: String(sequence.reduce((all, n) => all * (n + 1), 1)),
    };
  }

  handles(values: Values) {
    const [tip, fork] = this.#angle(values);
    const angle = numberOf(values, 'angle');
    return [
      this.plane.handle({
        id: 'angle',
        label: 'Split angle, from the upright',
        at: tip,
        colour: this.host.colours().answer,
        said: `${angle} degrees`,
        move: (x, y) => this.host.set('angle', (Math.atan2(x - fork[0], Math.max(1e-3, y - fork[1])) * 180) / Math.PI),
        turn: (steps) => this.host.set('angle', angle + steps),
      }),
    ];
  }

  /** Where the split angle is taken hold of, and the lowest fork, from which it is measured. */
  #angle(values: Values): readonly [tip: Point, fork: Point] {
    const height = Math.min(HEIGHT / numberOf(values, 'res'), 7);
    const angle = (numberOf(values, 'angle') * Math.PI) / 180;
    return [
      [6 * Math.sin(angle), height + 6 * Math.cos(angle)],
      [0, height],
    ];
  }

  text(values: Values): string {
    return `A trunk of ${numberOf(values, 'res')} segments that gives off ${numberOf(values, 'splits')} clones a segment, each at ${numberOf(values, 'angle')} degrees.`;
  }
}

/** 4.2: a stem that forks. */
export const splits = (aspen: Species): FigureSpec => ({
  id: 'splits',
  title: 'Splits: a stem and its clones',
  aspect: 1.3,
  controls: [
    { id: 'splits', label: 'nSegSplits', min: 0, max: 2, step: 0.1, value: 1 },
    { id: 'res', label: 'nCurveRes', min: 1, max: 6, step: 1, value: 3 },
    { id: 'angle', label: 'nSplitAngle', unit: '°', min: 0, max: 60, step: 1, value: 30 },
  ],
  readouts: [
    { id: 'sequence', label: 'Clones at the end of each segment' },
    { id: 'formula', label: 'Product of (clones + 1)' },
    { id: 'stems', label: 'Stems grown' },
  ],
  open: (values) => editorLink('quaking-aspen', changes(values), 2),
  stage: (host) => new Splits(host, aspen),
});
