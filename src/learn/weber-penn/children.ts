import { downAngleAlong, shapeRatio } from '../../core/grow/stem-shape.ts';
import type { Tree } from '../../core/grow/tree.ts';
import type { Species } from '../../core/species/species.ts';
import { type FigureSpec, numberOf, switchOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { AspenFigure } from './aspen-figure.ts';
import { type Changes, changedSpecies, editorLink } from './changed-species.ts';
import { printedDown } from './printed.ts';
import { declinationAt, sketchTree, stemsOf } from './sketch.ts';

const TRUNK = 13;
const BARE = 0.4;

const changes = (values: Values): Changes => ({
  tree: { baseSize: BARE, scale: TRUNK, scaleV: 0, levels: 2 },
  levels: {
    0: { curveV: 0 },
    1: { downAngle: numberOf(values, 'down'), downAngleV: numberOf(values, 'along'), curve: 0, curveV: 0 },
  },
  leaves: { count: 0 },
});

/** Where in the graph beside the tree an angle stands, and back. */
const across = (degrees: number): number => 6.6 + (degrees / 140) * 5.4;
const degreesAt = (x: number): number => ((x - 6.6) / 5.4) * 140;

class Children extends AspenFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    p.begin({ x: [-5, 12.5], y: [-0.4, 15], equal: true });
    p.line([p.x[0], 0], [5, 0], { colour: c.line, width: 1 });
    const tree = this.grow(JSON.stringify(values), () => changedSpecies(this.aspen, changes(values)), 1);
    sketchTree(p, tree, { colours: c });
    this.#graph(values, tree);
    const main = stemsOf(tree, 1);
    const mean = main.reduce((all, i) => all + declinationAt(tree, i), 0) / Math.max(1, main.length);
    const angle = (height: number): string => this.#angle(values, height * TRUNK).toFixed(0);
    return { mean: mean.toFixed(1), bottom: angle(BARE), top: angle(1), stems: String(main.length) };
  }

  /** The ends of the line of the angles: the upper one turns it, the lower one moves all of it. */
  handles(values: Values) {
    const [down, along] = [numberOf(values, 'down'), numberOf(values, 'along')];
    const colour = this.host.colours().answer;
    const ends = [
      { id: 'bottom', label: 'Angle at the base of the crown', z: BARE * TRUNK },
      { id: 'top', label: 'Angle at the top', z: TRUNK },
    ] as const;
    return ends.map(({ id, label, z }) => {
      const angle = this.#angle(values, z);
      return this.plane.handle({
        id,
        label,
        at: [across(angle), z],
        ways: 'across',
        colour,
        said: `${angle.toFixed(0)} degrees`,
        move: (x) => {
          const wanted = degreesAt(x);
          if (id === 'bottom') this.host.set('down', down + wanted - angle);
          // Above 0 the number is a tolerance, and the line stands upright.
          else this.host.set('along', Math.min(0, (wanted - down) / (1 - 2 * shapeRatio(0, 0))));
        },
        turn: (steps) =>
          id === 'bottom' ? this.host.set('down', down + steps) : this.host.set('along', Math.min(0, along) + steps),
      });
    });
  }

  /** Height across, beside the tree at the same heights: the angle at which a branch leaves. */
  #graph(values: Values, tree: Tree): void {
    const c = this.host.colours();
    const p = this.plane;
    const at = across;
    for (const degrees of [0, 45, 90, 135]) {
      p.line([at(degrees), BARE * TRUNK], [at(degrees), TRUNK], { colour: c.hairline, width: 1 });
      p.text([at(degrees), BARE * TRUNK], `${degrees}°`, {
        size: 12,
        colour: c.soft,
        align: 'center',
        baseline: 'top',
        shift: [0, 6],
      });
    }
    p.text([at(70), BARE * TRUNK], 'down angle', {
      size: 12,
      colour: c.soft,
      align: 'center',
      baseline: 'top',
      shift: [0, 24],
    });
    const heights = Array.from({ length: 41 }, (_, i) => TRUNK * (BARE + ((1 - BARE) * i) / 40));
    const line = (f: (height: number) => number): Point[] => heights.map((z): Point => [at(f(z)), z]);
    if (switchOf(values, 'printed')) {
      const printed = (z: number): number =>
        printedDown(
          numberOf(values, 'down'),
          numberOf(values, 'along'),
          shapeRatio(0, (TRUNK - z) / (TRUNK * (1 - BARE))),
        );
      p.polyline(line(printed), { colour: c.wrong, width: 2, dash: [7, 5] });
    }
    p.polyline(
      line((z) => this.#angle(values, z)),
      { colour: c.answer, width: 2 },
    );
    for (const i of stemsOf(tree, 1))
      p.dot([at(declinationAt(tree, i)), (tree.stems.parentZ[i] as number) * TRUNK], 3, { colour: c.level1 });
  }

  #angle(values: Values, z: number): number {
    const [down, along] = [numberOf(values, 'down'), numberOf(values, 'along')];
    return along < 0 ? downAngleAlong(down, along, TRUNK, z, BARE * TRUNK) : down;
  }

  text(values: Values): string {
    return `Branches leave the trunk at ${this.#angle(values, BARE * TRUNK).toFixed(0)} degrees at the crown's base and at ${this.#angle(values, TRUNK).toFixed(0)} at the top.`;
  }
}

/** 4.3: where and how children grow. */
export const children = (aspen: Species): FigureSpec => ({
  id: 'children',
  title: 'Down angles along the trunk of the aspen',
  aspect: 1.3,
  controls: [
    { id: 'down', label: '1DownAngle', unit: '°', min: 0, max: 120, step: 1, value: 60 },
    { id: 'along', label: '1DownAngleV', unit: '°', min: -70, max: 70, step: 1, value: -50 },
    { id: 'printed', label: 'Also the ± of the print', value: true },
  ],
  readouts: [
    { id: 'stems', label: 'Branches' },
    { id: 'bottom', label: 'Angle at the base of the crown', unit: '°' },
    { id: 'top', label: 'Angle at the top', unit: '°' },
    { id: 'mean', label: 'Mean of those grown', unit: '°' },
  ],
  open: (values) => editorLink('quaking-aspen', changes(values)),
  stage: (host) => new Children(host, aspen),
});
