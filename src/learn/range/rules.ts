import {
  type Fraction,
  type FractionOptions,
  fractions,
  type Item,
  POINT_MASS,
  printedJumps,
} from '../../core/lod/fractions.ts';
import { TABLE_2, TABLE_RANGES, type TableRow } from '../../core/lod/table-2.ts';
import { SEASONS, type Season } from '../../core/species/season.ts';
import { type Colours, choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';

/** The curves of the plot: an item, as what, and the row of Table 2 that counts it. */
const CURVES: readonly {
  readonly item: Item;
  readonly as: keyof Fraction;
  readonly row: TableRow;
  readonly colour: keyof Colours;
}[] = [
  { item: 'trunk', as: 'polygons', row: 'trunkTriangles', colour: 'level0' },
  { item: 'trunk', as: 'thin', row: 'trunkLines', colour: 'level0' },
  { item: 'main', as: 'polygons', row: 'mainTriangles', colour: 'level1' },
  { item: 'main', as: 'thin', row: 'mainLines', colour: 'level1' },
  { item: 'other', as: 'polygons', row: 'otherTriangles', colour: 'level2' },
  { item: 'other', as: 'thin', row: 'otherLines', colour: 'level2' },
  { item: 'leaves', as: 'polygons', row: 'leafTriangles', colour: 'answer' },
  { item: 'leaves', as: 'thin', row: 'leafPoints', colour: 'answer' },
];

const MOST: readonly [number, number] = [Math.log10(5), Math.log10(2000)];
const LEFT = 44;
const NAMES = { trunk: 'Trunk', main: 'Main branches', other: 'Other branches', leaves: 'Leaves' } as const;
const ROWS = ['trunk', 'main', 'other', 'leaves'] as const;

const percent = (part: number): string => `${(100 * part).toFixed(0)}\u00a0%`;

/** A fraction as it is drawn: of leaf points one a mass always remains. */
function drawnPart(item: Item, as: keyof Fraction, range: number, options: FractionOptions): number {
  const part = fractions(range, options)[item][as];
  return item === 'leaves' && as === 'thin' ? Math.max(part, 1 / POINT_MASS) : part;
}

class Rules extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const c = this.host.colours();
    const p = this.plane;
    const { height } = this.host.size;
    const season = choiceOf(values, 'season') as Season;
    const options = { quality: numberOf(values, 'quality'), season };
    const range = numberOf(values, 'range');
    const asPrinted = options.quality === 1 && (season === 'summer' || season === 'autumn');
    const strip = (height - 34) / ROWS.length;
    ROWS.forEach((item, row) => {
      p.begin(
        {
          x: MOST,
          y: [0, 1],
          margin: { left: LEFT, right: 16, top: row * strip + 22, bottom: height - (row + 1) * strip - 2 },
        },
        { keep: row > 0 },
      );
      p.line([MOST[0], 0], [MOST[1], 0], { colour: c.line, width: 1 });
      p.line([MOST[0], 1], [MOST[1], 1], { colour: c.hairline, width: 1 });
      p.text([MOST[0], 1], NAMES[item], { size: 12, baseline: 'bottom', shift: [0, -4] });
      p.text([MOST[0], 1], '1', { size: 12, colour: c.soft, align: 'right', baseline: 'middle', shift: [-6, 0] });
      p.text([MOST[0], 0], '0', { size: 12, colour: c.soft, align: 'right', baseline: 'middle', shift: [-6, 0] });
      const jumps = printedJumps(options).filter((jump) => jump.item === item);
      for (const curve of CURVES.filter((each) => each.item === item)) {
        const of = (x: number): number => drawnPart(item, curve.as, 10 ** x, options);
        p.graph(of, { colour: c[curve.colour], width: 2.5, dash: curve.as === 'thin' ? [6, 5] : [] });
        for (const { as, at, before, after } of jumps) {
          if (as !== curve.as) continue;
          p.line([Math.log10(at), before], [Math.log10(at), after], { colour: c.wrong, width: 2 });
        }
        if (!asPrinted) continue;
        const most = Math.max(...TABLE_2[curve.row]);
        TABLE_RANGES.forEach((metres, i) => {
          const at: Point = [Math.log10(metres), TABLE_2[curve.row][i]! / most];
          p.dot(at, 4, { colour: c.well });
          p.dot(at, 3, { colour: c.rest });
        });
      }
      p.line([Math.log10(range), 0], [Math.log10(range), 1], { colour: c.ink, width: 1 });
    });
    for (const metres of [5, 10, 30, 100, 300, 1000])
      p.text([Math.log10(metres), 0], `${metres} m`, {
        size: 12,
        colour: c.soft,
        align: 'center',
        baseline: 'top',
        shift: [0, 8],
      });
    const now = (item: Item, as: keyof Fraction): string => percent(drawnPart(item, as, range, options));
    return Object.fromEntries(ROWS.map((item) => [item, `${now(item, 'polygons')} · ${now(item, 'thin')}`]));
  }

  handles(values: Values) {
    const p = this.plane;
    const x = Math.log10(numberOf(values, 'range'));
    return [
      p.handle({
        id: 'range',
        label: 'Range',
        at: [x, 0],
        ways: 'across',
        said: `${numberOf(values, 'range')} metres`,
        move: (to) => this.host.set('range', 10 ** to),
      }),
    ];
  }

  text(values: Values): string {
    const now = fractions(numberOf(values, 'range'), {
      quality: numberOf(values, 'quality'),
      season: choiceOf(values, 'season') as Season,
    });
    return `At ${numberOf(values, 'range')} metres: ${ROWS.map((item) => `${NAMES[item].toLowerCase()} ${percent(now[item].polygons)} as surfaces and ${percent(now[item].thin)} as lines or points`).join('; ')}.`;
  }
}

/** The rules of section 5 against Table 2. */
export const rules: FigureSpec = {
  id: 'rules',
  title: 'The rules, and Table 2',
  aspect: 1.15,
  controls: [
    { id: 'range', label: 'Calibrated range', unit: 'm', min: 5, max: 2000, step: 1, value: 120 },
    { id: 'quality', label: 'Quality', min: 0.1, max: 2, step: 0.05, value: 1 },
    { id: 'season', label: 'Season', options: SEASONS.map((value) => ({ value, label: value })), value: 'summer' },
  ],
  readouts: ROWS.map((item) => ({
    id: item,
    label: NAMES[item],
  })),
  page: {
    name: 'Count them',
    address: (values) =>
      `range.html?range=${numberOf(values, 'range')}&quality=${Math.min(1, numberOf(values, 'quality'))}&season=${choiceOf(values, 'season')}`,
  },
  stage: (host) => new Rules(host),
};
