import { type FigureSpec, numberOf, switchOf, type Values } from '../figure.ts';
import { Plane } from '../plane.ts';
import { ALONE, mean, median, ratiosOf, rounds } from './noise.ts';

const found = (values: Values) =>
  rounds(numberOf(values, 'rounds'), numberOf(values, 'load') / 100, switchOf(values, 'turns'));

export const NOISE_FIGURE: FigureSpec = {
  id: 'noise',
  title: 'Two programs on a busy machine',
  aspect: 1.9,
  controls: [
    { id: 'load', label: 'Other work', unit: '%', min: 0, max: 100, step: 1, value: 60 },
    { id: 'rounds', label: 'Rounds', min: 1, max: 41, step: 2, value: 15 },
    { id: 'turns', label: 'In turn: A, B, A, B …', value: false },
  ],
  readouts: [
    { id: 'means', label: 'B / A by means' },
    { id: 'medians', label: 'By medians' },
    { id: 'byRound', label: 'Median of the rounds’ ratios' },
    { id: 'true', label: 'The truth' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    return {
      draw(values) {
        const { a, b } = found(values);
        const turns = switchOf(values, 'turns');
        const count = a.length;
        plane.begin({ x: [0, 2], y: [0, 45], margin: { left: 44, right: 16, top: 16, bottom: 30 } });
        const colours = host.colours();
        for (const y of [0, 10, 20, 30, 40]) {
          plane.line([0, y], [2, y], { colour: y === 0 ? colours.line : colours.hairline, width: 1 });
          plane.text([0, y], String(y), {
            size: 12,
            colour: colours.soft,
            align: 'right',
            baseline: 'middle',
            shift: [-6, 0],
          });
        }
        plane.text([0, 45], 'milliseconds', { size: 12, baseline: 'top', shift: [8, 0] });
        plane.text([2, 0], 'time', { size: 12, align: 'right', baseline: 'bottom', shift: [0, -6] });
        const at = (i: number, second: boolean): number =>
          turns ? (2 * (i + (second ? 0.75 : 0.25))) / count : (i + 0.5) / count + (second ? 1 : 0);
        const show = (times: readonly number[], second: boolean, colour: string): void => {
          const base = second ? ALONE.b : ALONE.a;
          const range: [number, number] = turns ? [0, 2] : second ? [1, 2] : [0, 1];
          plane.line([range[0], base], [range[1], base], { colour: colours.rest, width: 1.5, dash: [3, 4] });
          plane.line([range[0], median(times)], [range[1], median(times)], { colour, width: 2 });
          plane.line([range[0], mean(times)], [range[1], mean(times)], { colour, width: 1.5, dash: [9, 5] });
          times.forEach((time, i) => {
            const x = at(i, second);
            // A is a dot, B a bar: not by colour alone.
            if (second) plane.line([x, time - 1], [x, time + 1], { colour, width: 4 });
            else plane.dot([x, time], 4, { colour });
          });
        };
        show(a, false, colours.velocity);
        show(b, true, colours.answer);
        plane.text([turns ? 0 : 0.02, a[0] as number], 'A', { colour: colours.velocity, bold: true, shift: [6, 18] });
        plane.text([turns ? 0.05 : 1.02, b[0] as number], 'B', { colour: colours.answer, bold: true, shift: [6, -14] });
        const ratios = ratiosOf({ a, b });
        return {
          means: ratios.means.toFixed(2),
          medians: ratios.medians.toFixed(2),
          byRound: ratios.byRound.toFixed(2),
          true: (ALONE.b / ALONE.a).toFixed(2),
        };
      },
      handles(values) {
        const { a } = found(values);
        const worst = a.indexOf(Math.max(...a));
        const turns = switchOf(values, 'turns');
        const load = numberOf(values, 'load') / 100;
        const time = a[worst] as number;
        // How far the slowest of A stands out, for the whole load.
        const reach = load > 0 ? (time - ALONE.a) / load : 0;
        const x = turns ? (2 * (worst + 0.25)) / a.length : (worst + 0.5) / a.length;
        return reach === 0
          ? []
          : [
              plane.handle({
                id: 'load',
                label: 'Slowest round of A',
                ways: 'up',
                at: [x, time],
                colour: host.colours().velocity,
                said: `other work ${numberOf(values, 'load')} percent`,
                move: (_, y) => host.set('load', Math.max(1, (100 * (y - ALONE.a)) / reach)),
              }),
            ];
      },
      text(values) {
        const { means, medians, byRound } = ratiosOf(found(values));
        return `B takes ${means.toFixed(2)} times as long by means, ${medians.toFixed(2)} by medians and ${byRound.toFixed(2)} by the rounds' own ratios; alone it takes ${ALONE.b / ALONE.a}.`;
      },
    };
  },
};
