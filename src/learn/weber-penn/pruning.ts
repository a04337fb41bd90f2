import { envelopeRatio } from '../../core/grow/stem-shape.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies, editorLink } from './changed-species.ts';
import { remembered } from './grown.ts';
import { printedEnvelope } from './printed.ts';
import { sketchTree } from './sketch.ts';

const SCALE = 13;
const BARE = 0.25;
const POWERS = { powerLow: 0.5, powerHigh: 0.5 };

const changes = (values: Values, ratio = numberOf(values, 'ratio')): Changes => ({
  tree: { scale: SCALE, scaleV: 0, baseSize: BARE, levels: 3, shape: 3 },
  levels: { 0: { curveV: 10 }, 1: { length: 0.5, downAngle: 70, downAngleV: 0 }, 2: { branches: 12 } },
  leaves: { count: 0 },
  pruning: { ratio, width: numberOf(values, 'width'), widthPeak: numberOf(values, 'peak'), ...POWERS },
});

class Pruning extends AspenFigure {
  readonly #whole = remembered();

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-8.5, 8.5], y: [-0.4, 13.6], equal: true });
    p.line([p.x[0], 0], [p.x[1], 0], { colour: c.line, width: 1 });
    const whole = this.#whole('whole', () => changedSpecies(this.aspen, changes(values, 0)), 5);
    const tree = this.grow(JSON.stringify(values), () => changedSpecies(this.aspen, changes(values)), 5);
    sketchTree(p, whole, { colours: c, colour: c.hairline });
    sketchTree(p, tree, { colours: c });
    const shape = { widthPeak: numberOf(values, 'peak'), ...POWERS };
    const edge = (f: typeof envelopeRatio, sign: number): Point[] =>
      Array.from({ length: 161 }, (_, i): Point => {
        const ratio = i / 160;
        return [sign * SCALE * numberOf(values, 'width') * f(ratio, shape), SCALE - ratio * SCALE * (1 - BARE)];
      });
    const jump = printedEnvelope(1 - shape.widthPeak, shape);
    for (const sign of [-1, 1]) {
      if (Math.abs(jump - 1) > 0.01)
        p.polyline(edge(printedEnvelope, sign), { colour: c.wrong, width: 1.5, dash: [6, 4] });
      p.polyline(edge(envelopeRatio, sign), { colour: c.answer, width: 2 });
    }
    const sum = (of: typeof tree): number => of.stems.length.reduce((all, length) => all + length, 0);
    return { wood: sum(tree).toFixed(0), before: sum(whole).toFixed(0), jump: jump.toFixed(2) };
  }

  handles(values: Values) {
    const p = this.plane;
    const [width, peak] = [numberOf(values, 'width'), numberOf(values, 'peak')];
    const low = SCALE * BARE;
    return [
      p.handle({
        id: 'peak',
        label: 'Widest place of the envelope',
        at: [SCALE * width, low + peak * (SCALE - low)],
        colour: this.host.colours().answer,
        said: `${(SCALE * width).toFixed(1)} metres out, ${(100 * peak).toFixed(0)} per cent up the crown`,
        move: (x, y) => {
          this.host.set('width', x / SCALE);
          this.host.set('peak', (y - low) / (SCALE - low));
        },
      }),
    ];
  }

  text(values: Values): string {
    return `An aspen with long branches, pruned to an envelope ${(2 * SCALE * numberOf(values, 'width')).toFixed(1)} metres wide.`;
  }
}

/** 4.6: the envelope. */
export const pruning = (aspen: Species): FigureSpec => ({
  id: 'pruning',
  title: 'The envelope (the paper’s figure 2)',
  aspect: 1.25,
  controls: [
    { id: 'width', label: 'PruneWidth', min: 0.05, max: 0.6, step: 0.01, value: 0.32 },
    { id: 'peak', label: 'PruneWidthPeak', min: 0.05, max: 0.95, step: 0.01, value: 0.6 },
    { id: 'ratio', label: 'PruneRatio', min: 0, max: 1, step: 0.05, value: 1 },
  ],
  readouts: [
    { id: 'before', label: 'Stems in all, unpruned', unit: 'm' },
    { id: 'wood', label: 'Stems in all, pruned', unit: 'm' },
    { id: 'jump', label: 'As printed, width just below the peak' },
  ],
  open: (values) => editorLink('quaking-aspen', changes(values), 5),
  stage: (host) => new Pruning(host, aspen),
});
