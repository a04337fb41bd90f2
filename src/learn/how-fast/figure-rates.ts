import { choiceOf, type FigureSpec, numberOf } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import type { Kind, Measured } from './measured.ts';
import { type Cost, costOf, costThrough, type Rate, rateAt } from './paper-figures.ts';

/** What a graph of rates shows. */
export interface RateGraph {
  readonly kind: Kind;
  readonly title: string;
  /** What there are so many of: "vertices"; and what is done so often a second: "frames". */
  readonly things: string;
  readonly done: string;
  readonly machine: string;
  readonly paper: readonly [Rate, Rate];
  /** Another computer, measured by this page. */
  readonly other: readonly Rate[];
  readonly otherName: string;
  /** Sizes shown, and rates. */
  readonly sizes: Point;
  readonly rates: Point;
  /** The view of the editor that shows what is counted. */
  readonly view: 'wireframe' | 'control';
  /** In thousands. */
  readonly size: { readonly min: number; readonly max: number; readonly step: number; readonly value: number };
}

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** A power of ten as it stands at an axis: 1 000, 10 000, 10⁶. */
const powerText = (power: number): string =>
  power > 5 ? `10${SUPERSCRIPTS[power]}` : String(10 ** power).replace(/\B(?=(\d{3})+$)/g, '\u202f');

const said = (x: number | null): string => {
  if (x === null || !Number.isFinite(x)) return '–';
  return x >= 100 ? x.toFixed(0) : x >= 10 ? x.toFixed(1) : x.toFixed(2);
};

/** A graph of rates over sizes: the paper's two figures and the line through them, another computer's, and the reader's own. */
export function rateFigure(graph: RateGraph, measured: Measured): FigureSpec {
  const { kind, things, done, paper, other } = graph;
  const theirs = costOf(paper);
  const others = costThrough(other);
  return {
    id: kind,
    title: graph.title,
    aspect: 1.6,
    controls: [
      { id: 'size', label: `Thousand ${things}`, ...graph.size },
      {
        id: 'axes',
        label: 'Axes',
        options: [
          { value: 'log', label: 'powers of ten' },
          { value: 'plain', label: 'plain, as in the paper' },
        ],
        value: 'log',
      },
    ],
    readouts: [
      { id: 'paper', label: `Paper, ${graph.machine}`, unit: 'a second' },
      { id: 'yours', label: 'Your machine', unit: 'a second' },
      { id: 'ratio', label: 'Yours / paper’s' },
      { id: 'each', label: `You pay for each of the ${things}`, unit: 'ns' },
    ],
    open: () => `s=quaking-aspen&seed=1&leaves=0&view=${graph.view}`,
    page: { name: 'Benchmark', address: () => 'bench.html' },
    stage: (host) => {
      const plane = new Plane(host);
      measured.watch(() => host.redraw());
      const cost = (): Cost | null => costThrough(measured.rates(kind));
      const log = (): boolean => choiceOf(host.values(), 'axes') === 'log';
      const x = (size: number): number => (log() ? Math.log10(size) : size);
      const y = (rate: number): number => (log() ? Math.log10(Math.max(rate, 1e-3)) : rate);
      const chosen = (): number => 1000 * numberOf(host.values(), 'size');
      const mine = (): number | null => {
        const found = cost();
        return found ? rateAt(found, chosen()) : null;
      };
      const scales = (): void => {
        const { soft, line } = host.colours();
        if (!log()) {
          plane.grid();
          plane.axes({ x: things, y: `${done} a second` });
          return;
        }
        const [x0, x1] = plane.x;
        const [y0, y1] = plane.y;
        const rule = { colour: host.colours().hairline, width: 1 };
        for (let power = Math.ceil(x0); power <= x1; power++) {
          plane.line([power, y0], [power, y1], rule);
          plane.text([power, y0], powerText(power), {
            size: 12,
            colour: soft,
            align: 'center',
            baseline: 'top',
            shift: [0, 6],
          });
        }
        for (let power = Math.ceil(y0); power <= y1; power++) {
          plane.line([x0, power], [x1, power], rule);
          plane.text([x0, power], powerText(power), {
            size: 12,
            colour: soft,
            align: 'right',
            baseline: 'middle',
            shift: [-6, 0],
          });
        }
        plane.polyline(
          [
            [x0, y1],
            [x0, y0],
            [x1, y0],
          ],
          { colour: line, width: 1 },
        );
        plane.text([x1, y0], things, { size: 12, align: 'right', baseline: 'bottom', shift: [0, -6] });
        plane.text([x0, y1], `${done} a second`, { size: 12, baseline: 'top', shift: [8, 0] });
      };
      const curve = (of: Cost, colour: string, width: number, dash: readonly number[]): void => {
        const [from, to] = graph.sizes;
        const points = Array.from({ length: 121 }, (_, i): Point => {
          const size = from * (to / from) ** (i / 120);
          return [x(size), Math.min(plane.y[1] + 1e3, y(rateAt(of, size)))];
        });
        plane.polyline(
          points.filter(([, rate]) => rate <= plane.y[1] && rate >= plane.y[0]),
          { colour, width, dash },
        );
      };
      const dots = (rates: readonly Rate[], colour: string, radius: number): void => {
        for (const { size, perSecond } of rates) {
          const at: Point = [x(size), y(perSecond)];
          if (at[1] <= plane.y[1] && at[0] <= plane.x[1]) plane.dot(at, radius, { colour });
        }
      };
      return {
        draw() {
          const own = measured.rates(kind);
          const highest = Math.max(graph.rates[1], ...(log() ? own.map(({ perSecond }) => perSecond * 1.3) : []));
          const plain = !log();
          const view: { x: Point; y: Point } = plain
            ? { x: [0, paper[1].size * 1.25], y: [0, paper[0].perSecond * 2.2] }
            : {
                x: [Math.log10(graph.sizes[0]), Math.log10(graph.sizes[1])],
                y: [Math.log10(graph.rates[0]), Math.log10(highest)],
              };
          plane.begin({ ...view, margin: { left: 56, bottom: 32, right: 20, top: 18 } });
          const colours = host.colours();
          scales();
          if (others) {
            curve(others, colours.line, 1.5, [2, 4]);
            dots(other, colours.line, 3);
            // Below the line, where nothing else stands.
            const narrow = host.size.width < 480;
            const named = other[narrow ? 1 : 2] as Rate;
            plane.text([x(named.size), y(named.perSecond)], graph.otherName, {
              colour: colours.soft,
              size: 12,
              align: narrow ? 'left' : 'right',
              shift: narrow ? [-30, 62] : [-8, 20],
            });
          }
          curve(theirs, colours.rest, 2, [8, 5]);
          dots(paper, colours.rest, 5);
          const [first] = paper;
          plane.text([x(first.size), y(first.perSecond)], host.size.width < 480 ? 'paper' : `paper, ${graph.machine}`, {
            colour: colours.rest,
            size: 12,
            shift: [10, -8],
          });
          const found = cost();
          if (found) curve(found, colours.answer, 2, []);
          dots(own, colours.answer, 4.5);
          const top = own.at(-1);
          if (top) {
            plane.text([x(top.size), y(top.perSecond)], 'your machine', {
              colour: colours.answer,
              size: 12,
              align: 'right',
              shift: [-8, -10],
            });
          }
          const size = chosen();
          plane.line([x(size), plane.y[0]], [x(size), plane.y[1]], { colour: colours.ink, width: 1, alpha: 0.5 });
          const yours = mine();
          const printed = rateAt(theirs, size);
          return {
            paper: said(printed),
            yours: said(yours),
            ratio: yours === null ? '–' : `${(yours / printed).toPrecision(3)} ×`,
            // Left out where there is none: the text then says what to do.
            ...(found ? { each: said(found.each) } : {}),
          };
        },
        handles: () => {
          const size = chosen();
          return [
            plane.handle({
              id: 'size',
              label: things,
              ways: 'across',
              // On plain axes small sizes are above the sheet, and large ones beside it.
              at: plane.within([x(size), y(rateAt(theirs, size))]),
              colour: host.colours().rest,
              said: `${Math.round(size / 1000)} thousand`,
              move: (px) => host.set('size', (log() ? 10 ** px : px) / 1000),
            }),
          ];
        },
        text() {
          const yours = mine();
          const here = yours === null ? 'Your machine is not measured yet' : `your machine would do ${said(yours)}`;
          return `At ${Math.round(chosen() / 1000)} thousand ${things} the paper's ${graph.machine} does ${said(rateAt(theirs, chosen()))} ${done} a second; ${here}.`;
        },
      };
    },
  };
}
