import { SHAPES } from '../../core/grow/stem-shape.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureHost, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { type Changes, changedSpecies } from './changed-species.ts';
import { remembered } from './grown.ts';
import { sketchTree } from './sketch.ts';

/** The paper's shapes and, as the ninth on the plate, a cone that runs to a point; 8, the envelope, has a figure of its own. */
const SHOWN = [0, 1, 2, 3, 4, 5, 6, 7, 9] as const;

/** Metres of each trunk. */
const HEIGHT = 10;

const changes = (shape: number, values: Values): Changes => ({
  tree: {
    shape,
    baseSize: numberOf(values, 'baseSize'),
    scale: HEIGHT,
    scaleV: 0,
    levels: 2,
    ratio: 0.012,
    attractionUp: 0,
  },
  levels: {
    0: { curveV: 0 },
    1: {
      branches: numberOf(values, 'branches'),
      length: 0.36,
      lengthV: 0,
      downAngle: numberOf(values, 'down'),
      downAngleV: 0,
      curve: 0,
      curveV: 0,
    },
  },
  leaves: { count: 0 },
});

class Shapes extends PlaneFigure {
  readonly #aspen: Species;
  readonly #growers = SHOWN.map(() => remembered());

  constructor(host: FigureHost, aspen: Species) {
    super(host);
    this.#aspen = aspen;
  }

  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    const { width, height } = this.host.size;
    const columns = width < 480 ? 3 : 5;
    const rows = Math.ceil(SHOWN.length / columns);
    let stems = 0;
    SHOWN.forEach((shape, i) => {
      const [column, row] = [i % columns, Math.floor(i / columns)];
      p.begin(
        {
          x: [-4.4, 4.4],
          y: [-2, 10.6],
          equal: true,
          margin: {
            left: 4 + (column * width) / columns,
            right: 4 + ((columns - 1 - column) * width) / columns,
            top: 4 + (row * height) / rows,
            bottom: 4 + ((rows - 1 - row) * height) / rows,
          },
        },
        { keep: i > 0 },
      );
      p.line([-3, 0], [3, 0], { colour: c.line, width: 1 });
      const key = JSON.stringify(values);
      const tree = this.#growers[i]!(key, () => changedSpecies(this.#aspen, changes(shape, values)), 4);
      stems += tree.stems.count;
      sketchTree(p, tree, { colours: c });
      const name = SHAPES[shape]!;
      p.text([0, -0.3], `${shape} ${name}`, {
        size: width < 480 ? 11 : 12,
        align: 'center',
        baseline: 'top',
        colour: shape === 9 ? c.soft : c.ink,
      });
    });
    const bare = HEIGHT * numberOf(values, 'baseSize');
    p.line([-3, bare], [3, bare], { colour: c.answer, width: 1, dash: [4, 4] });
    return { stems: String(stems) };
  }

  /** On the last tree of the plate, whose plane it is. */
  handles(values: Values) {
    const base = numberOf(values, 'baseSize');
    return [
      this.plane.handle({
        id: 'baseSize',
        label: 'Base of the crowns',
        at: [0, HEIGHT * base],
        ways: 'up',
        colour: this.host.colours().answer,
        said: `${Math.round(100 * base)} per cent of the trunk`,
        move: (_, y) => this.host.set('baseSize', y / HEIGHT),
      }),
    ];
  }

  text(): string {
    return 'Nine crowns that differ in nothing but Shape: conical, spherical, hemispherical, cylindrical, tapered cylindrical, flame, inverse conical, tend flame, and our own cone.';
  }
}

/** 4.3: the silhouettes of a crown. */
export const shapes = (aspen: Species): FigureSpec => ({
  id: 'shapes',
  title: 'Shape: how long a branch may get',
  aspect: 1.45,
  controls: [
    { id: 'down', label: '1DownAngle', unit: '°', min: 20, max: 130, step: 1, value: 70 },
    { id: 'baseSize', label: 'BaseSize', min: 0, max: 0.6, step: 0.01, value: 0.15 },
    { id: 'branches', label: '1Branches', min: 10, max: 120, step: 1, value: 60 },
  ],
  readouts: [{ id: 'stems', label: 'Stems on the plate' }],
  stage: (host) => new Shapes(host, aspen),
});
