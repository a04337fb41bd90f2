import { handlesOf } from '../core/math/frames.ts';
import { hashPcg, hashUnit } from '../core/math/hash.ts';
import type { Vec3 } from '../core/math/vec3.ts';
import { BRANCH_LAYERS, MECHANICS_SIZE, TEXEL } from '../core/pack/layout.ts';
import type { PackedTree } from '../core/pack/packed.ts';
import { texelArray, wordTexels } from '../core/pack/texel-array.ts';

/** Half the side of the box that the pieces fill, metres. */
export const STREWN_HALF = 4;

/** So many pieces strewn over a box: curved, a metre long, each the whole of a stem. For timing: same count, same pieces. */
export function strewnPieces(count: number): PackedTree {
  const restPose = texelArray(count, 4);
  const branches = texelArray(count, Object.keys(BRANCH_LAYERS).length);
  const plane = restPose.width * restPose.height * TEXEL;
  let h = 99;
  const draw = (): number => {
    h = hashPcg(h);
    return hashUnit(h);
  };
  const spread = (size: number): Vec3 => [size * (2 * draw() - 1), size * (2 * draw() - 1), size * (2 * draw() - 1)];
  for (let i = 0; i < count; i++) {
    const point = spread(STREWN_HALF);
    const way = spread(1);
    const across = handlesOf({ p0: [0, 0, 0], p1: way, p2: way, p3: way }, [0, 0, 1]).t0;
    for (let k = 0; k < 4; k++) {
      restPose.data.set(point, k * plane + i * TEXEL);
      restPose.data[k * plane + i * TEXEL + 3] = k < 3 ? across[k] : 0;
      const bend = spread(0.12);
      for (let axis = 0; axis < 3; axis++) point[axis] += 0.33 * way[axis] + bend[axis] * k;
    }
    branches.data.set([i, 0, 1, 0.012 + 0.01 * draw()], i * TEXEL);
    branches.data.set([1, draw(), 0, 0], plane + i * TEXEL); // no parent, so no collar
  }
  return {
    pieceCount: count,
    leafCount: 0,
    depthStart: new Uint32Array([0, count]),
    pieces: texelArray(count, 5),
    restPose,
    mechanics: new Float32Array(MECHANICS_SIZE * count),
    branches,
    leaves: wordTexels(0, 1),
    leafLength: 0,
    levels: [{ start: 0, count }],
    bounds: new Float32Array([-STREWN_HALF, -STREWN_HALF, -STREWN_HALF, STREWN_HALF, STREWN_HALF, STREWN_HALF]),
    crown: new Float32Array([0, 0, 0, STREWN_HALF, STREWN_HALF, STREWN_HALF]),
  };
}
