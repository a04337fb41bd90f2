import type { LeafTriangles } from '../../../src/core/mesh/expand-leaves.ts';

/** A picture of leaves from the side (x to the right, z up): 1 where one covers the middle of a pixel. */
export interface Silhouette {
  readonly width: number;
  readonly height: number;
  readonly covered: Uint8Array;
}

/** The area that is looked at: least and greatest x and z, metres. */
export type Frame = readonly [x0: number, z0: number, x1: number, z1: number];

/** Rasters triangles in parallel projection along y, `scale` pixels a metre. */
export function silhouette({ position, index }: LeafTriangles, [x0, z0, x1, z1]: Frame, scale: number): Silhouette {
  const width = Math.ceil((x1 - x0) * scale);
  const height = Math.ceil((z1 - z0) * scale);
  const covered = new Uint8Array(width * height);
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [index[i]! * 3, index[i + 1]! * 3, index[i + 2]! * 3];
    const [ax, ay] = [(position[a]! - x0) * scale, (position[a + 2]! - z0) * scale];
    const [bx, by] = [(position[b]! - x0) * scale, (position[b + 2]! - z0) * scale];
    const [cx, cy] = [(position[c]! - x0) * scale, (position[c + 2]! - z0) * scale];
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (Math.abs(area) < 1e-12) continue;
    const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
    const right = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
    const low = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
    const high = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
    for (let y = low; y <= high; y++) {
      for (let x = left; x <= right; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const u = ((bx - px) * (cy - py) - (cx - px) * (by - py)) / area;
        const v = ((cx - px) * (ay - py) - (ax - px) * (cy - py)) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) covered[y * width + x] = 1;
      }
    }
  }
  return { width, height, covered };
}

/** Pixels that are covered. */
export const coverage = ({ covered }: Silhouette): number => covered.reduce((sum, one) => sum + one, 0);
