import { addScaled, dot, scale, unit, type Vec3 } from '../../core/math/vec3.ts';
import type { Colours } from '../figure.ts';
import type { MeshPoint, Rows } from './branch-mesh.ts';
import { axesOf, blend, type Cell, channels, type Eye, paint, projector } from './solid.ts';

/** How a surface is painted. */
export interface Look {
  /** Lines of the sheet: how strong, 0 none to 1. */
  readonly wires?: number;
  /** 0 bark, the default, to 1: the white of graph paper. */
  readonly paper?: number;
  /** No faces: lines alone, the far side too. */
  readonly hollow?: boolean;
  /** Colour of a cell in place of the lit bark. */
  readonly tint?: (cell: readonly MeshPoint[]) => string;
  /** The normal to be lit by, in place of the point's own. */
  readonly normal?: (point: MeshPoint) => Vec3;
}

/** Over the reader's left shoulder, in the picture's axes: right, up, near. */
const LIGHT = unit([-0.55, 0.65, 0.6]);

/** Where the light comes from, in space. */
export function lightFrom(eye: Pick<Eye, 'yaw' | 'pitch'>): Vec3 {
  const [right, up, near] = axesOf(eye);
  return addScaled(addScaled(scale(right, LIGHT[0]), up, LIGHT[1]), near, LIGHT[2]);
}

/** Brightness 0..1 of a surface whose normal has this cosine with the light; its far side is lit by the sky a little. */
export const lightOn = (cosine: number): number => 0.1 + 0.9 * ((1 + cosine) / 2) ** 1.7;

/** The bark, or the paper that it begins as, from shadow to light, for a brightness 0..1. */
export function barkTones(colours: Colours, paper = 0): (brightness: number) => string {
  const bark = channels(colours.level1);
  const towards = (part: Vec3, sheet: Vec3): Vec3 => part.map((x, k) => x + ((sheet[k] as number) - x) * paper) as Vec3;
  const dark = towards(bark.map((x) => x * 0.22) as Vec3, [128, 122, 106]);
  const middle = towards(bark, [214, 208, 192]);
  const bright = towards(bark.map((x) => x + (255 - x) * 0.62) as Vec3, [255, 253, 246]);
  return (f) => (f < 0.55 ? blend(dark, middle, f / 0.55) : blend(middle, bright, (f - 0.55) / 0.45));
}

/** Paints a surface of rows, lit from over the reader's shoulder; both sides show, the inner one darker. */
export function paintRows(
  context: CanvasRenderingContext2D,
  rows: Rows,
  eye: Eye,
  colours: Colours,
  { wires = 0, paper = 0, hollow = false, tint, normal = (point) => point.normal }: Look = {},
): void {
  const project = projector(eye);
  const light = lightFrom(eye);
  const tone = barkTones(colours, paper);
  const seen = rows.map((row) => row.map(({ position }) => project(position)));
  const lit = rows.map((row) => row.map((point) => dot(normal(point), light)));
  const line =
    wires > 0
      ? `rgb(${channels(colours.well)
          .map((x) => (x > 127 ? 29 : 8))
          .join(' ')} / ${wires})`
      : null;
  const cells: Cell[] = [];
  for (let i = 0; i + 1 < rows.length; i++) {
    const [row, next] = [rows[i] as readonly MeshPoint[], rows[i + 1] as readonly MeshPoint[]];
    for (let k = 0; k + 1 < row.length; k++) {
      const places = [
        [i, k],
        [i + 1, k],
        [i + 1, k + 1],
        [i, k + 1],
      ] as const;
      const corners = places.map(([a, b]) => seen[a]?.[b] as [number, number, number]);
      const [p, q, r] = corners as [Vec3, Vec3, Vec3, Vec3];
      // Counter-clockwise from outside; on the stage y points down.
      const outside = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0;
      const facing = places.reduce((sum, [a, b]) => sum + (lit[a]?.[b] as number), 0) / 4;
      const points = [row[k], next[k], next[k + 1], row[k + 1]] as MeshPoint[];
      const colour = tint
        ? tint(points)
        : tone(outside ? lightOn(facing) : 0.08 + (0.2 + 0.5 * paper) * Math.max(0, -facing));
      cells.push({
        corners: corners.map(([x, y]) => [x, y] as const),
        near: (corners as Vec3[]).reduce((sum, corner) => sum + corner[2], 0) / 4,
        fill: hollow ? null : colour,
        stroke: hollow ? (line ?? colours.soft) : line,
      });
    }
  }
  paint(context, cells, hollow ? 1 : 0.7);
}
