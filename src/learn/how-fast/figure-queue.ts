import { choiceOf, type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane } from '../plane.ts';
import { niceStep, ticks } from '../plane-map.ts';
import { signed } from '../signed.ts';
import { timeline, type Waiting } from './queue.ts';

const found = (values: Values) =>
  timeline(numberOf(values, 'cost'), numberOf(values, 'frames'), choiceOf(values, 'wait') as Waiting);

export const QUEUE_FIGURE: FigureSpec = {
  id: 'queue',
  title: 'What does the timer see?',
  aspect: 2.2,
  controls: [
    { id: 'cost', label: 'A frame takes the GPU', unit: 'ms', min: 0.5, max: 16, step: 0.1, value: 6 },
    { id: 'frames', label: 'Frames timed', min: 1, max: 12, step: 1, value: 4 },
    {
      id: 'wait',
      label: 'The timer waits',
      options: [
        { value: 'none', label: 'for nothing' },
        { value: 'each', label: 'after each frame' },
        { value: 'end', label: 'once, at the end' },
      ],
      value: 'none',
    },
  ],
  readouts: [
    { id: 'told', label: 'The timer says, a frame', unit: 'ms' },
    { id: 'true', label: 'The GPU needs', unit: 'ms' },
    { id: 'off', label: 'Off by', unit: '%' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    let end = 0;
    return {
      draw(values) {
        const { cpu, gpu, stop, told } = found(values);
        const cost = numberOf(values, 'cost');
        // A scale that followed the drag would run away from the pointer.
        if (!host.held) end = Math.max(stop, gpu.at(-1)?.to ?? 0) * 1.08 + 1;
        const narrow = host.size.width < 480;
        plane.begin({ x: [0, end], y: [0, 3], margin: { left: narrow ? 64 : 88, right: 20, top: 20, bottom: 30 } });
        const colours = host.colours();
        const { soft, line, hairline } = colours;
        for (const x of ticks([0, end], niceStep(end))) {
          plane.line([x, 0], [x, 3], { colour: hairline, width: 1 });
          plane.text([x, 0], String(x), { size: 12, colour: soft, align: 'center', baseline: 'top', shift: [0, 6] });
        }
        plane.line([0, 0], [end, 0], { colour: line, width: 1 });
        plane.text([end, 0], 'milliseconds', { size: 12, align: 'right', baseline: 'bottom', shift: [0, -6] });
        const row = (y: number, name: string): void =>
          plane.text([0, y + 0.28], name, { size: 13, align: 'right', baseline: 'middle', shift: [-10, 0] });
        row(1.9, narrow ? 'page' : 'the page');
        row(0.75, narrow ? 'GPU' : 'the GPU');
        const box = (from: number, to: number, y: number, colour: string): void => {
          plane.area(
            [
              [from, y],
              [to, y],
              [to, y + 0.56],
              [from, y + 0.56],
            ],
            { colour, alpha: 0.85 },
          );
          plane.line([to, y], [to, y + 0.56], { colour: colours.well, width: 1.5 });
        };
        for (const { from, to } of cpu) box(from, to, 1.9, colours.rest);
        for (const { from, to } of gpu) box(from, to, 0.75, colours.answer);
        const honest = Math.abs(told / cost - 1) < 0.1;
        const colour = honest ? colours.answer : colours.wrong;
        plane.line([stop, 0], [stop, 3], { colour, width: 2, dash: honest ? [] : [7, 5] });
        plane.text([stop, 2.95], 'the timer stops', {
          colour,
          size: 12,
          baseline: 'top',
          align: stop > end * 0.6 ? 'right' : 'left',
          shift: [stop > end * 0.6 ? -8 : 8, 0],
        });
        return { told: told.toFixed(2), true: cost.toFixed(2), off: signed((told / cost - 1) * 100, 0) };
      },
      handles(values) {
        const [first] = found(values).gpu;
        if (!first) return [];
        return [
          plane.handle({
            id: 'cost',
            label: 'End of the first frame on the GPU',
            ways: 'across',
            at: [first.to, 1.03],
            colour: host.colours().answer,
            said: `${numberOf(values, 'cost')} milliseconds`,
            move: (x) => host.set('cost', x - first.from),
          }),
        ];
      },
      text(values) {
        const { told } = found(values);
        return `The timer says ${told.toFixed(1)} milliseconds a frame; the GPU needs ${numberOf(values, 'cost')}.`;
      },
    };
  },
};
