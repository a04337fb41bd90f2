import type { Tree } from '../grow/tree.ts';
import type { LeafAttachments, Pieces } from '../pieces/pieces.ts';

/** Box and crown of a tree at rest, as PackedTree has them. */
export interface Extent {
  readonly bounds: Float32Array;
  readonly crown: Float32Array;
}

/** Least radius of a crown in metres: shading divides by it. */
const LEAST_CROWN = 0.01;

/**
 * Box around control points, radii and leaves, and the crown's ellipsoid: centroid of the leaves (of the pieces' ends where
 * there are none) and, along each axis, the radius of the solid ellipsoid with the same variance, sqrt(5) deviations.
 */
export function extentOf(tree: Tree, pieces: Pieces, attachments: LeafAttachments): Extent {
  const box = new Float64Array([Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]);
  const { species, stems, leaves } = tree;
  const { control, stem, count } = pieces;
  const sum = new Float64Array(6);
  for (let i = 0; i < count; i++) {
    const s = stem[i];
    const margin = stems.baseRadius[s] * (stems.level[s] === 0 ? widest(species.tree) : 1 + species.tree.bulgeDepth);
    for (let k = 0; k < 12; k += 3) {
      include(box, control[12 * i + k], control[12 * i + k + 1], control[12 * i + k + 2], margin);
    }
    if (leaves.count === 0) gather(sum, control[12 * i + 9], control[12 * i + 10], control[12 * i + 11]);
  }
  const reach = 1 + species.leaves.petiole;
  for (let i = 0; i < leaves.count; i++) {
    const c = 12 * attachments.piece[i];
    const u = attachments.v[i];
    const w = 1 - u;
    const b0 = w * w * w;
    const b1 = 3 * w * w * u;
    const b2 = 3 * w * u * u;
    const b3 = u * u * u;
    const x = b0 * control[c] + b1 * control[c + 3] + b2 * control[c + 6] + b3 * control[c + 9];
    const y = b0 * control[c + 1] + b1 * control[c + 4] + b2 * control[c + 7] + b3 * control[c + 10];
    const z = b0 * control[c + 2] + b1 * control[c + 5] + b2 * control[c + 8] + b3 * control[c + 11];
    include(box, x, y, z, leaves.length[i] * reach);
    gather(sum, x, y, z);
  }
  return {
    bounds: Float32Array.from(count > 0 ? box : new Float64Array(6)),
    crown: ellipsoid(sum, leaves.count || count),
  };
}

/** Largest factor of flare, lobes and bulges on the radius of a trunk. */
const widest = (t: Tree['species']['tree']): number =>
  (1 + Math.max(0, t.flare)) * (1 + t.lobeDepth) * (1 + t.bulgeDepth);

function include(box: Float64Array, x: number, y: number, z: number, margin: number): void {
  if (x - margin < box[0]) box[0] = x - margin;
  if (y - margin < box[1]) box[1] = y - margin;
  if (z - margin < box[2]) box[2] = z - margin;
  if (x + margin > box[3]) box[3] = x + margin;
  if (y + margin > box[4]) box[4] = y + margin;
  if (z + margin > box[5]) box[5] = z + margin;
}

function gather(sum: Float64Array, x: number, y: number, z: number): void {
  sum[0] += x;
  sum[1] += y;
  sum[2] += z;
  sum[3] += x * x;
  sum[4] += y * y;
  sum[5] += z * z;
}

function ellipsoid(sum: Float64Array, count: number): Float32Array {
  const crown = new Float32Array(6);
  for (let k = 0; k < 3; k++) {
    const mean = count > 0 ? sum[k] / count : 0;
    const variance = count > 0 ? Math.max(0, sum[3 + k] / count - mean * mean) : 0;
    crown[k] = mean;
    crown[3 + k] = Math.max(LEAST_CROWN, Math.sqrt(5 * variance));
  }
  return crown;
}
