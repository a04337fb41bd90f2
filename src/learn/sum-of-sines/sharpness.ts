import { meanPush } from '../../core/wind/force.ts';
import { choiceOf, type FigureSpec, numberOf, switchOf, type Values } from '../figure.ts';
import type { Point } from '../plane.ts';
import { PlaneFigure } from '../plane-figure.ts';
import { signed } from '../signed.ts';
import { periodOf, printedPush, sharpPush } from './sharp-push.ts';

class Sharpness extends PlaneFigure {
  draw(values: Values): Record<string, string> {
    const plane = this.plane;
    const { answer, wrong, rest, soft } = this.host.colours();
    const [k, zeroMean] = [numberOf(values, 'k'), switchOf(values, 'zero')];
    const printed = choiceOf(values, 'form') === 'printed';
    const push = (printed ? printedPush : sharpPush)(k, zeroMean);
    plane.begin({ x: [-0.25, 1.75], y: [-0.55, 1.12], margin: { left: 48, bottom: 30, top: 12, right: 16 } });
    plane.grid(0.25, 0.5);
    plane.axes({ x: 'turns', y: 'push, as a part of A' }, 0.25, 0.5);
    const ours = sharpPush(k, zeroMean);
    if (printed) plane.graph(ours, { colour: rest, dash: [5, 5] });
    this.#curve(push, printed ? wrong : answer);
    const { mean, valued, most } = periodOf(push);
    plane.line([-0.25, mean], [1.75, mean], { colour: rest, dash: [2, 4] });
    plane.text([1.75, mean], 'mean', { size: 12, colour: soft, align: 'right', shift: [-4, -5] });
    return {
      most: signed(most, 3),
      mean: signed(mean, 6),
      theory: signed(zeroMean ? 0 : meanPush(k), 6),
      lost: ((1 - valued) * 100).toFixed(0),
    };
  }

  handles(values: Values) {
    if (choiceOf(values, 'form') === 'printed' || switchOf(values, 'zero')) return [];
    const k = numberOf(values, 'k');
    return [
      this.plane.handle({
        id: 'half',
        label: 'Halfway up the slope',
        at: [1, 2 ** -k],
        ways: 'up',
        colour: this.host.colours().answer,
        said: `k is ${k}`,
        move: (_, y) => this.host.set('k', -Math.log2(Math.min(0.99, Math.max(0.001, y)))),
      }),
    ];
  }

  text(values: Values): string {
    const k = numberOf(values, 'k');
    return choiceOf(values, 'form') === 'printed'
      ? `As printed, with k of ${k}: the crest is ${(2 ** -k).toFixed(2)} high${Number.isInteger(k) ? '' : ', and half of the wave has no value'}.`
      : `With k of ${k} the push is 1 at the crest and ${(2 ** -k).toFixed(2)} halfway up.`;
  }

  /** The curve, filled; where it has no value, hatched along the axis. */
  #curve(push: (turns: number) => number, colour: string): void {
    const plane = this.plane;
    let part: Point[] = [];
    const flush = (): void => {
      const [first, last] = [part[0], part.at(-1)];
      if (first && last) {
        plane.area([[first[0], 0], ...part, [last[0], 0]], { colour, alpha: 0.13 });
        plane.polyline(part, { colour, width: 2.5 });
      }
      part = [];
    };
    const { wrong } = this.host.colours();
    for (let i = 0; i <= 800; i++) {
      const x = -0.25 + (2 * i) / 800;
      const y = push(x);
      if (Number.isNaN(y)) {
        flush();
        if (i % 8 === 0) plane.line([x, -0.06], [x + 0.02, 0.06], { colour: wrong, width: 1.2 });
      } else part.push([x, y]);
    }
    flush();
    for (const middle of [0.75]) {
      if (!Number.isNaN(push(middle))) continue;
      plane.text([middle, 0.1], 'no number', { colour: wrong, align: 'center', size: 14 });
    }
  }
}

/** The exponent of equation 14, ours and as printed. */
export const sharpness: FigureSpec = {
  id: 'sharpness',
  title: 'How sharp a gust is',
  aspect: 1.9,
  controls: [
    {
      id: 'form',
      label: 'Form',
      value: 'ours',
      options: [
        { value: 'ours', label: '((1 + sin)/2)ᵏ' },
        { value: 'printed', label: 'As printed, (sin/2)ᵏ' },
      ],
    },
    { id: 'k', label: 'Sharpness k', min: 0.5, max: 8, step: 0.1, value: 2 },
    { id: 'zero', label: 'Take the mean off', value: false },
  ],
  readouts: [
    { id: 'most', label: 'Push at the crest' },
    { id: 'mean', label: 'Mean, measured' },
    { id: 'theory', label: 'Mean, by the formula' },
    { id: 'lost', label: 'Of the period without a value', unit: '%' },
  ],
  stage: (host) => new Sharpness(host),
};
