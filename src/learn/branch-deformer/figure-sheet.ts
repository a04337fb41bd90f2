import { type FigureSpec, numberOf } from '../figure.ts';
import { Plane } from '../plane.ts';
import { rolledPoint, rowsOf } from './branch-mesh.ts';
import { nearestValue } from './nearest-value.ts';
import { Orbit } from './orbit.ts';
import { type Eye, projector } from './solid.ts';
import { paintRows } from './surface-picture.ts';

const LENGTH = 2.2;
const RADIUS = 0.34;

/** How far the middle of a flat side lies inside the circle, as a part of the radius. */
export const cutOfSides = (sectors: number): number => 1 - Math.cos(Math.PI / sectors);

export const SHEET_FIGURE: FigureSpec = {
  id: 'sheet',
  title: 'The sheet rolls up',
  aspect: 1.9,
  controls: [
    { id: 'rolled', label: 'Rolled up', min: 0, max: 1, step: 0.01, value: 0.55 },
    { id: 'sectors', label: 'Sectors', min: 3, max: 48, step: 1, value: 12 },
    { id: 'bands', label: 'Bands', min: 1, max: 24, step: 1, value: 9 },
  ],
  readouts: [
    { id: 'vertices', label: 'Vertices' },
    { id: 'triangles', label: 'Triangles' },
    { id: 'cut', label: 'Flat sides cut in by', unit: '% of the radius' },
    { id: 'pixels', label: 'Unseen below a radius of', unit: 'pixels' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const orbit = new Orbit(host, -0.55, 0.5);
    const eyeNow = (): Eye => {
      const { width, height } = host.size;
      const scale = Math.min(width / 3.1, height / 2);
      return { ...orbit.angles, scale, centre: [LENGTH / 2, 0, -0.1], x: width / 2, y: height / 2 };
    };
    return {
      reset: () => orbit.reset(),
      draw(values) {
        plane.begin({ x: [0, 1], y: [0, 1] });
        const colours = host.colours();
        const [sectors, bands] = [numberOf(values, 'sectors'), numberOf(values, 'bands')];
        const rolled = numberOf(values, 'rolled');
        const rows = rowsOf(sectors, bands, (u, turns) => rolledPoint(u, turns, LENGTH, RADIUS, rolled));
        paintRows(plane.context, rows, eyeNow(), colours, { wires: 0.35, paper: 1 });
        return {
          vertices: (sectors + 1) * (bands + 1),
          triangles: 2 * sectors * bands,
          cut: (100 * cutOfSides(sectors)).toFixed(2),
          pixels: (0.5 / cutOfSides(sectors)).toFixed(1),
        };
      },
      handles(values) {
        const project = projector(eyeNow());
        const corner = (rolled: number) => project(rolledPoint(0, 1, LENGTH, RADIUS, rolled).position);
        const [x, y] = corner(numberOf(values, 'rolled'));
        const edge = {
          id: 'edge',
          label: 'Edge of the sheet',
          x,
          y,
          said: `${Math.round(100 * numberOf(values, 'rolled'))} percent rolled up`,
          move: (px: number, py: number) =>
            host.set(
              'rolled',
              nearestValue(0, 1, 0.01, (rolled) => {
                const [qx, qy] = corner(rolled);
                return Math.hypot(qx - px, qy - py);
              }),
            ),
        };
        return [edge];
      },
      text: (values) =>
        `A sheet of ${numberOf(values, 'sectors')} sectors and ${numberOf(values, 'bands')} bands, ${Math.round(100 * numberOf(values, 'rolled'))} percent rolled up.`,
    };
  },
};
