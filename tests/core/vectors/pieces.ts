import type { Vec3 } from '../../../src/core/math/vec3.ts';
import { FITTED, fitCubicTangents } from '../../../src/core/pieces/fit.ts';
import type { Adapters } from './case.ts';

export const pieces: Adapters = {
  fit_cubic: ({ points, t0, t1, iters }: { points: Vec3[]; t0: Vec3; t1: Vec3; iters: number }) => {
    const out = new Float64Array(FITTED);
    const err = fitCubicTangents(Float64Array.from(points.flat()), t0, t1, iters, out);
    const [x, y, z] = points[0];
    const rest = [0, 3, 6].map((k) => [x + out[k], y + out[k + 1], z + out[k + 2]]);
    return { P: [points[0], ...rest], err };
  },
};
