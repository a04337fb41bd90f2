import { newFrame } from '../../core/grow/frame.ts';
import { leafBend } from '../../core/grow/leaf-bend.ts';
import type { Tree } from '../../core/grow/tree.ts';
import type { Species } from '../../core/species/species.ts';
import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies } from './changed-species.ts';
import { printedLeafBend } from './printed.ts';
import { sketchTree } from './sketch.ts';

/** A twig that stands up like a small trunk, so that its leaves are leaves of a level-0 stem. */
const changes = (values: Values): Changes => ({
  tree: { scale: 1.2, scaleV: 0, levels: 2, baseSize: 0.1, ratio: 0.012, lobeDepth: 0, attractionUp: 0 },
  levels: {
    0: { curveV: 20, length: 1 },
    1: { branches: 9, length: 0.45, downAngle: 55, downAngleV: 0, curve: -30, curveV: 20 },
    2: { downAngle: 50, downAngleV: 10, rotate: 140 },
  },
  leaves: { count: numberOf(values, 'count'), scale: 0.13, scaleX: 0.8, bend: 0 },
});

/** A leaf's frame from its quaternion: axes x, y (normal), z (midrib). */
function frameOf({ leaves }: Tree, i: number): Float64Array {
  const [x, y, z, w] = leaves.orientation.subarray(4 * i, 4 * i + 4) as unknown as [number, number, number, number];
  const f = newFrame();
  f.set([
    1 - 2 * (y * y + z * z),
    2 * (x * y + w * z),
    2 * (x * z - w * y),
    2 * (x * y - w * z),
    1 - 2 * (x * x + z * z),
    2 * (y * z + w * x),
    2 * (x * z + w * y),
    2 * (y * z - w * x),
    1 - 2 * (x * x + y * y),
  ]);
  return f;
}

/** Where on its stem a leaf grows. */
function placeOf({ stems, leaves }: Tree, i: number): [number, number, number] {
  const stem = leaves.stem[i] as number;
  const [first, end] = [stems.nodeStart[stem] as number, stems.nodeStart[stem + 1] as number];
  const from = stems.zStart[stem] as number;
  const along = Math.min(0.999999, Math.max(0, ((leaves.z[i] as number) - from) / (1 - from))) * (end - 1 - first);
  const node = first + Math.floor(along);
  const part = along - Math.floor(along);
  const at = (k: number): number =>
    (1 - part) * (stems.nodePosition[3 * node + k] as number) + part * (stems.nodePosition[3 * node + 3 + k] as number);
  return [at(0), at(1), at(2)];
}

/** Half the outline of the paper's leaf (its figure 1): a hexagon, part of the length and of the width. */
const HEXAGON: readonly Point[] = [
  [0, 0],
  [0.35, 0.5],
  [0.7, 0.4],
  [1, 0],
  [0.7, -0.4],
  [0.35, -0.5],
];

/** The eye looks a little down on the twig. */
const DOWN = 0.35;

/** The bar beside the twig along which Bend is dragged: its place and its ends. */
const [BAR, LOW, HIGH] = [0.74, 0.3, 1.15];

class Leaves extends AspenFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-0.85, 0.85], y: [-0.05, 1.4], equal: true });
    const { bend: _, ...grown } = values;
    const tree = this.grow(JSON.stringify(grown), () => changedSpecies(this.aspen, changes(values)), 6);
    sketchTree(p, tree, { colours: c, leaves: false });
    const bend = numberOf(values, 'bend');
    const form = choiceOf(values, 'form') === 'printed' ? printedLeafBend : leafBend;
    const { scaleX } = tree.species.leaves;
    let lean = 0;
    const blades: { readonly depth: number; readonly points: Point[]; readonly light: number }[] = [];
    for (let i = 0; i < tree.leaves.count; i++) {
      const f = frameOf(tree, i);
      const [x, y, z] = placeOf(tree, i);
      form(f, x, y, bend);
      lean += Math.acos(Math.min(1, Math.max(-1, f[5]!)));
      const length = tree.leaves.length[i] as number;
      const points = HEXAGON.map(([along, across]): Point => {
        const v = (k: number): number => length * (along * f[6 + k]! + across * scaleX * f[k]!);
        return [x + v(0), z + v(2) - DOWN * (y + v(1))];
      });
      blades.push({ depth: y, points, light: f[5]! });
    }
    blades.sort((a, b) => b.depth - a.depth);
    for (const { points, light } of blades) {
      p.area(points, { colour: c.paper });
      p.area(points, { colour: c.answer, alpha: 0.25 + 0.5 * Math.max(0, light) });
      p.polyline([...points, points[0]!], { colour: c.answer, width: 1, alpha: 0.8 });
    }
    const bar = (y: number): Point => [BAR, y];
    p.line(bar(LOW), bar(HIGH), { colour: c.line, width: 1 });
    for (const [y, word] of [
      [LOW, 'as grown'],
      [HIGH, 'to the light'],
    ] as const)
      p.text(bar(y), word, {
        size: 12,
        colour: c.soft,
        align: 'right',
        baseline: y === LOW ? 'top' : 'bottom',
        shift: [12, y === LOW ? 14 : -14],
      });
    const degrees = (lean / Math.max(1, tree.leaves.count)) * (180 / Math.PI);
    return { leaves: String(tree.leaves.count), lean: degrees.toFixed(1) };
  }

  handles(values: Values) {
    const bend = numberOf(values, 'bend');
    return [
      this.plane.handle({
        id: 'bend',
        label: 'Bend towards the light',
        at: [BAR, LOW + (HIGH - LOW) * bend],
        ways: 'up',
        colour: this.host.colours().answer,
        said: `${Math.round(100 * bend)} per cent`,
        move: (_, y) => this.host.set('bend', (y - LOW) / (HIGH - LOW)),
      }),
    ];
  }

  text(values: Values): string {
    return `A twig with about ${numberOf(values, 'count')} leaves a stem, turned ${(100 * numberOf(values, 'bend')).toFixed(0)} per cent of the way to the light.`;
  }
}

/** 4.5 and 4.9: leaves and how they turn to the light. */
export const leaves = (aspen: Species): FigureSpec => ({
  id: 'leaves',
  title: 'Leaves turn to the light',
  aspect: 1.2,
  controls: [
    { id: 'bend', label: 'Bend', min: 0, max: 1, step: 0.01, value: 0.3 },
    { id: 'count', label: 'Leaves', min: 1, max: 40, step: 1, value: 14 },
    {
      id: 'form',
      label: 'Turned',
      options: [
        { value: 'ours', label: 'as corrected' },
        { value: 'printed', label: 'as printed' },
      ],
      value: 'ours',
    },
  ],
  readouts: [
    { id: 'leaves', label: 'Leaves on the twig' },
    { id: 'lean', label: 'Mean angle of a blade to the sky', unit: '°' },
  ],
  stage: (host) => new Leaves(host, aspen),
});
