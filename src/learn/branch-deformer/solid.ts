import { cross, dot, type Vec3 } from '../../core/math/vec3.ts';

/** From where a figure is seen: turned about the upright z axis, then tipped; pixels a metre, and where `centre` comes to lie. */
export interface Eye {
  readonly yaw: number;
  readonly pitch: number;
  readonly scale: number;
  readonly centre: Vec3;
  readonly x: number;
  readonly y: number;
}

/** The axes of the picture in space: to the right, up, and towards the eye. */
export function axesOf({ yaw, pitch }: Pick<Eye, 'yaw' | 'pitch'>): [right: Vec3, up: Vec3, near: Vec3] {
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  const near: Vec3 = [s * Math.cos(pitch), -c * Math.cos(pitch), Math.sin(pitch)];
  const right: Vec3 = [c, s, 0];
  return [right, cross(near, right), near];
}

/** A point of space in pixels, and how near it is. No perspective: lengths across the view compare. */
export function projector(eye: Eye): (p: Vec3) => [x: number, y: number, near: number] {
  const [right, up, near] = axesOf(eye);
  const at = [dot(right, eye.centre), dot(up, eye.centre)] as const;
  return (p) => [eye.x + eye.scale * (dot(right, p) - at[0]), eye.y - eye.scale * (dot(up, p) - at[1]), dot(near, p)];
}

/** A colour of the page, '#rrggbb' or rgb(), as three numbers 0..255. */
export function channels(colour: string): Vec3 {
  const hex = /^#(..)(..)(..)$/.exec(colour.trim());
  if (hex) return [1, 2, 3].map((i) => Number.parseInt(hex[i] as string, 16)) as Vec3;
  const short = /^#(.)(.)(.)$/.exec(colour.trim());
  if (short) return [1, 2, 3].map((i) => 17 * Number.parseInt(short[i] as string, 16)) as Vec3;
  const parts = colour.match(/[\d.]+/g)?.map(Number) ?? [];
  return [parts[0] ?? 128, parts[1] ?? 128, parts[2] ?? 128];
}

/** Between two colours, f of the way. */
export function blend(a: Vec3, b: Vec3, f: number): string {
  const g = Math.min(1, Math.max(0, f));
  const part = (k: 0 | 1 | 2): number => Math.round(a[k] + (b[k] - a[k]) * g);
  return `rgb(${part(0)} ${part(1)} ${part(2)})`;
}

/** One cell of a surface: four corners, and what it is painted with. */
export interface Cell {
  readonly corners: readonly (readonly [x: number, y: number])[];
  readonly near: number;
  readonly fill: string | null;
  readonly stroke: string | null;
}

/** Paints cells from the farthest to the nearest: enough for surfaces that do not cut through each other. */
export function paint(context: CanvasRenderingContext2D, cells: Cell[], width = 1): void {
  cells.sort((a, b) => a.near - b.near);
  context.lineJoin = 'round';
  for (const { corners, fill, stroke } of cells) {
    context.beginPath();
    corners.forEach(([x, y], i) => {
      if (i === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    });
    context.closePath();
    if (fill) {
      context.fillStyle = fill;
      context.fill();
      // Neighbours meet without a gap of half a pixel.
      context.strokeStyle = fill;
      context.lineWidth = 0.8;
      context.stroke();
      if (stroke) {
        context.strokeStyle = stroke;
        context.lineWidth = width;
        context.stroke();
      }
    } else if (stroke) {
      context.strokeStyle = stroke;
      context.lineWidth = width;
      context.stroke();
    }
  }
}
