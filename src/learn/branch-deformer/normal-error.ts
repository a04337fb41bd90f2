import { skjermoRadius } from '../../core/deform/radius.ts';
import { paperSurfacePoint } from '../../core/deform/surface.ts';
import { cross, dot, length, scale, subtract, unit, type Vec3 } from '../../core/math/vec3.ts';
import { type Branch, bentPoint } from './branch-mesh.ts';
import { naiveNormal, printedNormal } from './printed.ts';

/** Ways to the normal of the paper's surface, by the names of the figure's control. */
export const NORMALS: Readonly<Record<string, (branch: Branch, u: number, turns: number) => Vec3>> = {
  jacobian: (branch, u, turns) => bentPoint(branch, u, turns, true).normal,
  naive: ({ handles }, u, turns) =>
    naiveNormal(handles, u, Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns)),
  printed: ({ curve, handles, shape, radius }, u, turns) => {
    const [rho, slope, q] = skjermoRadius(shape, radius, u, turns);
    const angle = 2 * Math.PI * turns;
    return printedNormal(curve, handles, u, Math.cos(angle), Math.sin(angle), rho, slope, q);
  },
};

/** The outward normal by small differences of the paper's positions: slow, and true whatever is printed. */
export function differencedNormal({ curve, handles, shape, radius }: Branch, u: number, turns: number): Vec3 {
  const at = (s: number, t: number) => {
    const [rho, slope, q] = skjermoRadius(shape, radius, s, t);
    return paperSurfacePoint(curve, handles, s, Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t), rho, slope, q)
      .position;
  };
  const h = 1e-5;
  const along = subtract(at(u + h, turns), at(u - h, turns));
  const around = subtract(at(u, turns + h), at(u, turns - h));
  const n = unit(cross(around, along));
  const outward = naiveNormal(handles, u, Math.cos(2 * Math.PI * turns), Math.sin(2 * Math.PI * turns));
  return dot(n, outward) < 0 ? scale(n, -1) : n;
}

/** Degrees between two directions. */
export const degreesBetween = (a: Vec3, b: Vec3): number =>
  (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;
