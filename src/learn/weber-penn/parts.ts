import type { Species } from '../../core/species/species.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies, editorLink } from './changed-species.ts';
import { sketchTree, stemsOf } from './sketch.ts';

/** One trunk, a few branches and nothing random: as the paper draws its terms. */
const changes = (values: Values): Changes => ({
  tree: { baseSize: numberOf(values, 'baseSize'), scaleV: 0, levels: 2, shape: 7, attractionUp: 0 },
  levels: {
    0: { curveV: 0 },
    1: {
      branches: 14,
      length: numberOf(values, 'length'),
      lengthV: 0,
      downAngle: numberOf(values, 'down'),
      downAngleV: 0,
      curve: -30,
      curveV: 0,
      rotate: 180,
      rotateV: 0,
    },
  },
  leaves: { count: 0 },
});

class Parts extends AspenFigure {
  #tree(values: Values) {
    return this.grow(JSON.stringify(values), () => changedSpecies(this.aspen, changes(values)), 3);
  }

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-6.4, 6.4], y: [-0.6, 15], equal: true, margin: { top: 12, bottom: 12, left: 12, right: 12 } });
    p.line([p.x[0], 0], [p.x[1], 0], { colour: c.line, width: 1 });
    const tree = this.#tree(values);
    const { stems } = tree;
    // The trunk's frame turns with the seed: rows of branches are seen from where they go left and right.
    const main = stemsOf(tree, 1);
    const first = main[0];
    const at = first === undefined ? 0 : 9 * (stems.nodeStart[first] as number);
    const turn = -Math.atan2(stems.nodeFrame[at + 7] as number, stems.nodeFrame[at + 6] as number);
    sketchTree(p, tree, { colours: c, turn });
    const trunk = stems.length[0] as number;
    const bare = trunk * tree.species.tree.baseSize;
    const left = p.x[0] + 0.7;
    const measure = (x: number, from: number, to: number, text: string, colour = c.ink): void => {
      for (const y of [from, to]) p.line([x - 0.15, y], [x + 0.15, y], { colour, width: 1 });
      p.line([x, from], [x, to], { colour, width: 1 });
      p.text([x, (from + to) / 2], text, { shift: [8, 0], baseline: 'middle', colour });
    };
    measure(left, 0, trunk, 'Scale · 0Length');
    measure(left + 2.6, 0, bare, 'BaseSize', c.answer);
    p.line([left + 2.6, bare], [4, bare], { colour: c.answer, width: 1, dash: [4, 4] });
    const middle = main[Math.floor(main.length / 2)];
    if (middle !== undefined) {
      const offset = (stems.parentZ[middle] as number) * trunk;
      const down = numberOf(values, 'down');
      // The angle from the trunk's direction to where the branch leaves it, on the side on which it grows.
      const node = stems.nodeStart[middle] as number;
      const [x, y] = stems.nodePosition.subarray(3 * node + 3, 3 * node + 6) as unknown as [number, number];
      const side = x * Math.cos(turn) - y * Math.sin(turn) > 0 ? 1 : -1;
      const arc = Array.from({ length: 25 }, (_, i): readonly [number, number] => {
        const a = (down * i * Math.PI) / (24 * 180);
        return [side * 1.3 * Math.sin(a), offset + 1.3 * Math.cos(a)];
      });
      p.line([0, offset], [0, offset + 1.9], { colour: c.force, width: 1, dash: [4, 4] });
      p.polyline(arc, { colour: c.force, width: 2 });
      p.text(arc[16]!, '1DownAngle', { colour: c.force, shift: [side * 8, -4], align: side > 0 ? 'left' : 'right' });
    }
    const radius = stems.baseRadius[0] as number;
    p.text([0, 0], `radius ${radius.toFixed(2)} m`, {
      shift: [14, -8],
      size: 12,
      colour: c.soft,
    });
    const longest = Math.max(...main.map((i) => stems.length[i] as number));
    return {
      bare: bare.toFixed(1),
      branches: String(main.length),
      longest: longest.toFixed(2),
      radius: (1000 * Math.max(...main.map((i) => stems.baseRadius[i] as number))).toFixed(0),
    };
  }

  handles(values: Values) {
    const p = this.plane;
    const top = 13;
    return [
      p.handle({
        id: 'base',
        label: 'Base of the crown',
        at: [0, top * numberOf(values, 'baseSize')],
        ways: 'up',
        colour: this.host.colours().answer,
        said: `${(top * numberOf(values, 'baseSize')).toFixed(1)} metres`,
        move: (_, y) => this.host.set('baseSize', y / top),
      }),
    ];
  }

  text(values: Values): string {
    return `A trunk of 13 metres whose crown begins at ${(13 * numberOf(values, 'baseSize')).toFixed(1)} metres; its branches leave it at ${numberOf(values, 'down')} degrees.`;
  }
}

/** The paper's figure 1: what the words mean. */
export const parts = (aspen: Species): FigureSpec => ({
  id: 'parts',
  title: 'The parts of a tree (the paper’s figure 1)',
  aspect: 1.3,
  controls: [
    { id: 'baseSize', label: 'BaseSize', min: 0, max: 0.8, step: 0.01, value: 0.4 },
    { id: 'length', label: '1Length', min: 0.1, max: 0.6, step: 0.01, value: 0.3 },
    { id: 'down', label: '1DownAngle', unit: '°', min: 0, max: 130, step: 1, value: 60 },
  ],
  readouts: [
    { id: 'bare', label: 'Bare trunk', unit: 'm' },
    { id: 'branches', label: 'Branches grown of 14' },
    { id: 'longest', label: 'Longest branch', unit: 'm' },
    { id: 'radius', label: 'Its radius at the base', unit: 'mm' },
  ],
  open: (values) => editorLink('quaking-aspen', changes(values)),
  stage: (host) => new Parts(host, aspen),
});
