import { type Shape, skjermoRadius } from '../../core/deform/radius.ts';
import { paperSurfacePoint, surfacePoint } from '../../core/deform/surface.ts';
import type { Cubic } from '../../core/math/bezier.ts';
import type { Handles } from '../../core/math/frames.ts';
import { mix, unit, type Vec3 } from '../../core/math/vec3.ts';

/** A point of the surface and its outward direction, in metres. */
export interface MeshPoint {
  readonly position: Vec3;
  readonly normal: Vec3;
  /** Place on the unit grid: along the branch 0..1, and around it in turns. */
  readonly u: number;
  readonly turns: number;
}

/** Rows of points from the base to the tip; the last of a row stands where its first does, once around. */
export type Rows = readonly (readonly MeshPoint[])[];

export interface Branch {
  readonly shape: Shape;
  /** Radius at the base without flare, metres. */
  readonly radius: number;
  readonly curve: Cubic;
  readonly handles: Handles;
}

/** Every vertex of a grid of bands x sectors through `at`. */
export function rowsOf(
  sectors: number,
  bands: number,
  at: (u: number, turns: number) => Omit<MeshPoint, 'u' | 'turns'>,
): Rows {
  return Array.from({ length: bands + 1 }, (_, row) =>
    Array.from({ length: sectors + 1 }, (__, column) => {
      const [u, turns] = [row / bands, column / sectors];
      return { ...at(u, turns), u, turns };
    }),
  );
}

/** A point of the bent branch by the code that the shaders are held to: exact sections, or the paper's. */
export function bentPoint({ shape, radius, curve, handles }: Branch, u: number, turns: number, paper = false) {
  const [rho, slope, q] = skjermoRadius(shape, radius, u, turns);
  const angle = 2 * Math.PI * turns;
  const point = paper ? paperSurfacePoint : surfacePoint;
  return point(curve, handles, u, Math.cos(angle), Math.sin(angle), rho, slope, q);
}

/**
 * A sheet of the given width on its way to a tube: `rolled` 0 is flat, 1 closed, and its width stays. Along the x axis, theta = 0
 * on the side of +z, theta growing towards -y.
 */
export function rolledPoint(
  u: number,
  turns: number,
  length: number,
  radius: number,
  rolled: number,
): Omit<MeshPoint, 'u' | 'turns'> {
  const angle = 2 * Math.PI * (turns - 0.5);
  if (rolled < 1e-3) return { position: [u * length, angle * radius, -radius], normal: [0, 0, -1] };
  const r = radius / rolled;
  const a = angle * rolled;
  // Around the point of the sheet that stays below the axis: theta = half a turn.
  return {
    position: [u * length, r * Math.sin(a), r - radius - r * Math.cos(a)],
    normal: [0, Math.sin(a), -Math.cos(a)],
  };
}

/** The straight curve along x, and handles whose T is up and S to the left: what the deformer does to it is nothing. */
export const straight = (length: number): { curve: Cubic; handles: Handles } => {
  const l: Vec3 = [1, 0, 0];
  const t: Vec3 = [0, 0, 1];
  const at = (i: number): Vec3 => [(i * length) / 3, 0, 0];
  return {
    curve: { p0: at(0), p1: at(1), p2: at(2), p3: at(3) },
    handles: { l0: l, l1: l, l2: l, t0: t, t1: t, t2: t },
  };
};

/** The four steps of the deformer as one way from 0 to 3: the sheet, the cylinder (1), the straight branch (2), the bent branch (3). */
export function stagePoint(
  branch: Branch,
  length: number,
  stage: number,
  u: number,
  turns: number,
): Omit<MeshPoint, 'u' | 'turns'> {
  const sheet = rolledPoint(u, turns, length, branch.radius, Math.min(1, stage));
  if (stage <= 1) return sheet;
  const flat = bentPoint({ ...branch, ...straight(length) }, u, turns);
  const between = (a: { position: Vec3; normal: Vec3 }, b: { position: Vec3; normal: Vec3 }, f: number) => ({
    position: mix(a.position, b.position, f),
    normal: unit(mix(a.normal, b.normal, f), b.normal),
  });
  if (stage <= 2) return between(sheet, flat, stage - 1);
  return stage >= 3 ? bentPoint(branch, u, turns) : between(flat, bentPoint(branch, u, turns), stage - 2);
}
