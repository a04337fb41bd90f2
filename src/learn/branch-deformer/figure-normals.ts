import type { Vec3 } from '../../core/math/vec3.ts';
import { choiceOf, type FigureSpec } from '../figure.ts';
import { Plane } from '../plane.ts';
import { type Branch, bentPoint, type MeshPoint, type Rows, rowsOf } from './branch-mesh.ts';
import { branchOf, SHAPES, walk } from './example-branch.ts';
import { degreesBetween, differencedNormal, NORMALS } from './normal-error.ts';
import { Orbit } from './orbit.ts';
import { blend, channels, type Eye } from './solid.ts';
import { paintRows } from './surface-picture.ts';

const LENGTH = 2;
const SECTORS = 36;
const BANDS = 64;
/** Degrees at which the error is painted fully red. */
const RED = 45;

interface Measured {
  readonly rows: Rows;
  readonly normals: ReadonlyMap<MeshPoint, Vec3>;
  readonly errors: ReadonlyMap<MeshPoint, number>;
}

/** A branch, the normals of a way, and how far each is from the true one, degrees. */
function measure(branch: Branch, way: string): Measured {
  // Neither end: at the base there is no step back, and the tip is a point.
  const inside = (u: number): number => 0.004 + 0.992 * u;
  const rows = rowsOf(SECTORS, BANDS, (u, turns) => bentPoint(branch, inside(u), turns, true));
  const normals = new Map<MeshPoint, Vec3>();
  const errors = new Map<MeshPoint, number>();
  for (const point of rows.flat()) {
    const u = inside(point.u);
    const normal = (NORMALS[way] as (typeof NORMALS)[string])(branch, u, point.turns);
    normals.set(point, normal);
    errors.set(point, degreesBetween(normal, differencedNormal(branch, u, point.turns)));
  }
  return { rows, normals, errors };
}

export const NORMALS_FIGURE: FigureSpec = {
  id: 'normals',
  title: 'What the light sees',
  aspect: 1.7,
  controls: [
    {
      id: 'way',
      label: 'Normals',
      options: [
        { value: 'jacobian', label: 'Jacobian' },
        { value: 'naive', label: 'from the axis' },
        { value: 'printed', label: 'as printed' },
      ],
      value: 'naive',
    },
    {
      id: 'show',
      label: 'Show',
      options: [
        { value: 'light', label: 'the light' },
        { value: 'error', label: 'the error' },
      ],
      value: 'light',
    },
    {
      id: 'shape',
      label: 'Shape',
      options: [
        { value: 'knobbly', label: 'knobbly' },
        { value: 'limb', label: 'limb' },
        { value: 'cactus', label: 'cactus' },
      ],
      value: 'knobbly',
    },
  ],
  readouts: [
    { id: 'mean', label: 'Error of the normals, mean', unit: '°' },
    { id: 'most', label: 'Most', unit: '°' },
  ],
  stage: (host) => {
    const plane = new Plane(host);
    const orbit = new Orbit(host, -0.3, 0.35);
    const curve = walk(LENGTH, 48, -30, 30);
    let known: { key: string; found: Measured } | null = null;
    const measured = (): Measured => {
      const values = host.values();
      const [way, shape] = [choiceOf(values, 'way'), choiceOf(values, 'shape') as keyof typeof SHAPES];
      const key = `${way} ${shape}`;
      if (known?.key !== key) known = { key, found: measure(branchOf(SHAPES[shape], 0.2, curve), way) };
      return known.found;
    };
    const summary = (): { mean: number; most: number } => {
      const all = [...measured().errors.values()];
      return { mean: all.reduce((sum, x) => sum + x, 0) / all.length, most: Math.max(...all) };
    };
    const said = (x: number): string => (x < 0.001 ? 'below 0.001' : x.toFixed(x < 10 ? 3 : 1));
    return {
      reset: () => orbit.reset(),
      draw(values) {
        plane.begin({ x: [0, 1], y: [0, 1] });
        const colours = host.colours();
        const { width, height } = host.size;
        const scale = Math.min(width / 2.6, height / 1.75);
        const eye: Eye = { ...orbit.angles, scale, centre: [LENGTH * 0.47, 0, 0.3], x: width / 2, y: height / 2 };
        const { rows, normals, errors } = measured();
        const [right, wrong] = [channels(colours.hairline), channels(colours.wrong)];
        const tint = (cell: readonly MeshPoint[]): string =>
          blend(right, wrong, cell.reduce((sum, point) => sum + (errors.get(point) ?? 0), 0) / 4 / RED);
        paintRows(plane.context, rows, eye, colours, {
          normal: (point) => normals.get(point) ?? point.normal,
          ...(choiceOf(values, 'show') === 'error' ? { tint, wires: 0.2 } : {}),
        });
        const { mean, most } = summary();
        return { mean: said(mean), most: said(most) };
      },
      text() {
        const { mean, most } = summary();
        return `The normals are wrong by ${said(mean)} degrees in the mean and ${said(most)} at most.`;
      },
    };
  },
};
