import { splitSequence } from '../../core/grow/splits.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies, editorLink } from './changed-species.ts';
import { sketchTree } from './sketch.ts';

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

class Splits extends AspenFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-8, 8], y: [-0.4, 13.4], equal: true });
    p.line([p.x[0], 0], [p.x[1], 0], { colour: c.line, width: 1 });
    const tree = this.grow(JSON.stringify(values), () => changedSpecies(this.aspen, changes(values)), 2);
    const { stems } = tree;
    sketchTree(p, tree, { colours: c, turn: 0.5 });
    for (let i = 0; i < stems.count; i++) {
      if (stems.clone[i] !== 1) continue;
      const n = 3 * (stems.nodeStart[i] as number);
      const [x, y, z] = stems.nodePosition.subarray(n, n + 3) as unknown as [number, number, number];
      p.dot([x * Math.cos(0.5) - y * Math.sin(0.5), z], 3.5, { colour: c.force });
    }
    const sequence = splitSequence(numberOf(values, 'splits'), Math.max(0, numberOf(values, 'res') - 1));
    return {
      stems: String(stems.count),
      sequence: sequence.join(', ') || 'none',
      formula: String(sequence.reduce((all, n) => all * (n + 1), 1)),
    };
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
