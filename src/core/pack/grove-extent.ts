import type { Extent } from './extent.ts';
import { TREE_LAYERS } from './layout.ts';
import type { Standing } from './merge-trees.ts';
import type { TexelArray } from './packed.ts';
import { layerStart, texelArray } from './texel-array.ts';
import { turnOf } from './turn.ts';

/** Box around all trees of a grove where they stand, and the ellipsoid of all their crowns. */
export function groveExtent(standings: readonly Standing[]): Extent {
  const bounds = new Float32Array([Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]);
  const mean = new Float64Array(3);
  const square = new Float64Array(3);
  let weights = 0;
  for (const standing of standings) {
    const box = boxOf(standing);
    for (let k = 0; k < 3; k++) {
      bounds[k] = Math.min(bounds[k] as number, box[k] as number);
      bounds[3 + k] = Math.max(bounds[3 + k] as number, box[3 + k] as number);
    }
    const { tree, turn } = standing;
    const weight = tree.leafCount || tree.pieceCount;
    const [rx, ry, rz] = tree.crown.subarray(3) as unknown as [number, number, number];
    const [c, s] = turnOf(turn);
    // A solid ellipsoid's variance along an axis is a fifth of the radius' square.
    const spread = [c * c * rx * rx + s * s * ry * ry, s * s * rx * rx + c * c * ry * ry, rz * rz];
    crownCentre(standing).forEach((at, k) => {
      mean[k] = (mean[k] as number) + weight * at;
      square[k] = (square[k] as number) + weight * (at * at + (spread[k] as number) / 5);
    });
    weights += weight;
  }
  const crown = new Float32Array(6);
  for (let k = 0; k < 3; k++) {
    const centre = (mean[k] as number) / weights;
    crown[k] = centre;
    crown[3 + k] = Math.sqrt(5 * Math.max(1e-4, (square[k] as number) / weights - centre * centre));
  }
  return { bounds, crown };
}

/** Box of a tree where it stands: min x, y, z, max x, y, z in grove space. */
export function boxOf({ tree, x, y, z, turn }: Standing): number[] {
  const [x0, y0, z0, x1, y1, z1] = tree.bounds as unknown as [number, number, number, number, number, number];
  const [c, s] = turnOf(turn);
  const xs = [c * x0 - s * y0, c * x0 - s * y1, c * x1 - s * y0, c * x1 - s * y1];
  const ys = [s * x0 + c * y0, s * x0 + c * y1, s * x1 + c * y0, s * x1 + c * y1];
  return [Math.min(...xs) + x, Math.min(...ys) + y, z0 + z, Math.max(...xs) + x, Math.max(...ys) + y, z1 + z];
}

function crownCentre({ tree, x, y, z, turn }: Standing): [number, number, number] {
  const [cx, cy, cz] = tree.crown as unknown as [number, number, number];
  const [c, s] = turnOf(turn);
  return [c * cx - s * cy + x, s * cx + c * cy + y, cz + z];
}

/** The trees as layers of TREE_LAYERS; `leafLength` is the grove's. */
export function treeTexels(standings: readonly Standing[], leafLength: number): TexelArray {
  const out = texelArray(standings.length, Object.keys(TREE_LAYERS).length);
  standings.forEach((standing, i) => {
    const { tree, x, y, z, turn } = standing;
    const write = (layer: number, texel: readonly number[]): void => {
      out.data.set(texel, layerStart(out, layer) + 4 * i);
    };
    write(TREE_LAYERS.PLACE, [x, y, z, Math.max(tree.bounds[5] as number, 0.01)]);
    write(TREE_LAYERS.CROWN, [...crownCentre(standing), leafLength > 0 ? tree.leafLength / leafLength : 1]);
    write(TREE_LAYERS.RADII, [...tree.crown.subarray(3), 0]);
    write(TREE_LAYERS.TURN, [...turnOf(turn), 1, 1]);
  });
  return out;
}
