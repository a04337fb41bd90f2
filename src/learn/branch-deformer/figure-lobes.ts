import { type Shape, skjermoRadius } from '../../core/deform/radius.ts';
import { type FigureSpec, numberOf, type Values } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { PLAIN } from './example-branch.ts';

const PLACES = [0, 0.3, 0.6, 0.9] as const;
const APART = 3.1;

const shapeOf = (values: Values): Shape => ({
  ...PLAIN,
  taper: 3,
  lobes: numberOf(values, 'n'),
  lobeDepth: numberOf(values, 'd'),
  lobeFade: numberOf(values, 'fade'),
});

export const LOBES_FIGURE: FigureSpec = {
  id: 'lobes',
  title: 'Lobes around a stem',
  aspect: 2.6,
  controls: [
    { id: 'n', label: 'Number of lobes', min: 0, max: 12, step: 1, value: 7 },
    { id: 'd', label: 'Their depth', min: 0, max: 0.5, step: 0.01, value: 0.2 },
    { id: 'fade', label: 'Fade towards the tip', min: 0, max: 1, step: 0.05, value: 1 },
  ],
  readouts: [
    { id: 'foot', label: 'Depth at the foot' },
    { id: 'tip', label: 'Depth at u = 0.9' },
    { id: 'sectors', label: 'Sectors that they ask for' },
  ],
  open: (values) =>
    `s=quaking-aspen&seed=1&leaves=0&tree.lobes=${numberOf(values, 'n')}&tree.lobeDepth=${numberOf(values, 'd')}`,
  stage: (host) => {
    const plane = new Plane(host);
    /** Centre of a section: in a row, or two by two where the stage is narrow. */
    const narrow = (): boolean => host.size.width < 1.9 * host.size.height;
    const centre = (i: number): Point => (narrow() ? [(i % 2) * APART, -Math.floor(i / 2) * APART] : [i * APART, 0]);
    return {
      draw(values) {
        const [wide, high] = narrow() ? [1, 1] : [3, 0];
        plane.begin({
          x: [-1.6, wide * APART + 1.6],
          y: [-high * APART - 1.7, 1.5],
          equal: true,
          margin: { left: 8, right: 8, top: 8, bottom: 12 },
        });
        const colours = host.colours();
        const shape = shapeOf(values);
        PLACES.forEach((u, i) => {
          const [cx, cy] = centre(i);
          const outline = Array.from({ length: 181 }, (_, k): Point => {
            const turns = k / 180;
            const [r] = skjermoRadius(shape, 1, u, turns);
            return [cx + r * Math.cos(2 * Math.PI * turns), cy + r * Math.sin(2 * Math.PI * turns)];
          });
          const [middle] = skjermoRadius({ ...shape, lobeDepth: 0 }, 1, u, 0);
          plane.area(outline, { colour: colours.level1, alpha: 0.35 });
          for (let ring = 0.25; ring < 1; ring += 0.25) {
            plane.polyline(
              outline.map(([x, y]): Point => [cx + (x - cx) * ring, cy + (y - cy) * ring]),
              { colour: colours.level1, width: 1, alpha: 0.35 },
            );
          }
          plane.circle([cx, cy], middle, { colour: colours.rest, width: 1, dash: [4, 4] });
          plane.polyline(outline, { colour: colours.level0, width: 2 });
          plane.text([cx, cy - 1.45], `u = ${u}`, { colour: colours.soft, size: 12, align: 'center', baseline: 'top' });
        });
        const depth = (u: number): string => (shape.lobeDepth * (1 - u * shape.lobeFade)).toFixed(3);
        return { foot: depth(0), tip: depth(0.9), sectors: shape.lobes > 0 ? 4 * shape.lobes : '3 or more' };
      },
      handles(values) {
        const shape = shapeOf(values);
        if (shape.lobes === 0) return [];
        const angle = Math.PI / (2 * shape.lobes);
        const [cx, cy] = centre(0);
        const r = 1 + shape.lobeDepth;
        return [
          plane.handle({
            id: 'd',
            label: 'Depth of the lobes',
            at: [cx + r * Math.cos(angle), cy + r * Math.sin(angle)],
            colour: host.colours().level0,
            said: String(shape.lobeDepth),
            move: (x, y) => host.set('d', Math.hypot(x - cx, y - cy) - 1),
          }),
        ];
      },
      text: (values) =>
        `${numberOf(values, 'n')} lobes, ${numberOf(values, 'd')} deep at the foot and ${(numberOf(values, 'd') * (1 - 0.9 * numberOf(values, 'fade'))).toFixed(2)} near the tip.`,
    };
  },
};
