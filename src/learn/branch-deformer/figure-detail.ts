import { gridDetail } from '../../view/detail.ts';
import { type FigureSpec, numberOf } from '../figure.ts';
import { Plane, type Point } from '../plane.ts';
import { bentPoint, rowsOf } from './branch-mesh.ts';
import { branchOf, SHAPES, walk } from './example-branch.ts';
import { cutOfSides } from './figure-sheet.ts';
import type { Eye } from './solid.ts';
import { paintRows } from './surface-picture.ts';

const LENGTH = 2.4;
/** Pixels a metre at a metre's distance: a view of 30 degrees in a window 720 pixels high. */
const PIXELS = 1340;

export const DETAIL_FIGURE: FigureSpec = {
  id: 'detail',
  title: 'A sheet for every distance',
  aspect: 1.9,
  controls: [
    { id: 'distance', label: 'Distance', unit: 'm', min: 1, max: 120, step: 0.5, value: 8 },
    { id: 'radius', label: 'Thickness of the branch', unit: 'cm', min: 0.5, max: 20, step: 0.5, value: 10 },
    { id: 'level', label: 'Level of the stem', min: 0, max: 3, step: 1, value: 1 },
  ],
  readouts: [
    { id: 'pixels', label: 'Its radius on screen', unit: 'pixels' },
    { id: 'sheet', label: 'Sheet' },
    { id: 'triangles', label: 'Triangles' },
    { id: 'cut', label: 'Flat sides cut in by', unit: 'pixels' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const branch = branchOf(SHAPES.cone, 0.18, walk(LENGTH, 38, -28));
    const at = (u: number, turns: number) => bentPoint(branch, u, turns);
    const found = () => {
      const values = host.values();
      const pixels = ((numberOf(values, 'radius') / 200) * PIXELS) / numberOf(values, 'distance');
      return { pixels, ...gridDetail(numberOf(values, 'level'), pixels, 1, 'auto') };
    };
    const rail = (): { from: number; to: number; y: number } => {
      const { width, height } = host.size;
      return { from: 32, to: width - 32, y: height - 26 };
    };
    return {
      draw() {
        plane.begin({ x: [0, 1], y: [0, 1], margin: { left: 0, right: 0, top: 0, bottom: 0 } });
        const { context } = plane;
        const colours = host.colours();
        const { width, height } = host.size;
        const { pixels, sectors, bands } = found();
        const ribbon = sectors === 1;
        const eye: Eye = {
          yaw: -0.2,
          pitch: 0.22,
          scale: Math.min(width / 3.4, height / 1.9),
          centre: [LENGTH / 2, 0, 0.2],
          x: width / 2,
          y: height * 0.46,
        };
        const rows = ribbon ? rowsOf(1, bands, (u, turns) => at(u, turns < 0.5 ? 0 : 0.5)) : rowsOf(sectors, bands, at);
        paintRows(context, rows, eye, colours, { wires: 0.4 });
        // As large as it is on screen, beside its enlargement.
        const scale = (pixels / branch.radius) * 1;
        const box: Point = [width - 84, 64];
        context.strokeStyle = colours.hairline;
        context.strokeRect(box[0] - 64, box[1] - 44, 128, 88);
        context.save();
        context.beginPath();
        context.rect(box[0] - 64, box[1] - 44, 128, 88);
        context.clip();
        paintRows(context, rows, { ...eye, scale, x: box[0], y: box[1] }, colours);
        context.restore();
        context.fillStyle = colours.soft;
        context.font = '12px system-ui, sans-serif';
        context.textAlign = 'center';
        context.fillText('as large as it is', box[0], box[1] + 58);
        const { from, to, y } = rail();
        context.strokeStyle = colours.hairline;
        context.lineWidth = 2;
        context.beginPath();
        context.moveTo(from, y);
        context.lineTo(to, y);
        context.stroke();
        context.textAlign = 'left';
        context.fillText('near', from, y - 14);
        context.textAlign = 'right';
        context.fillText('far', to, y - 14);
        return {
          pixels: pixels.toFixed(pixels < 10 ? 2 : 0),
          sheet: ribbon ? `ribbon × ${bands}` : `${sectors} × ${bands}`,
          triangles: 2 * sectors * bands,
          cut: ribbon ? '–' : (pixels * cutOfSides(sectors)).toFixed(2),
        };
      },
      handles(values) {
        const { from, to, y } = rail();
        const distance = numberOf(values, 'distance');
        // Even steps of the handle are even factors of the distance.
        const share = Math.log(distance) / Math.log(120);
        return [
          {
            id: 'distance',
            label: 'Distance',
            ways: 'across',
            x: from + share * (to - from),
            y,
            said: `${distance} metres`,
            move: (px) => host.set('distance', 120 ** Math.min(1, Math.max(0, (px - from) / (to - from)))),
          },
        ];
      },
      text() {
        const { pixels, sectors, bands } = found();
        const sheet = sectors === 1 ? `a ribbon of ${bands} bands` : `a sheet of ${sectors} sectors and ${bands} bands`;
        return `At a radius of ${pixels.toFixed(1)} pixels the branch is drawn with ${sheet}.`;
      },
    };
  },
};
