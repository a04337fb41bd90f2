import { aboutX, aboutZ } from '../deform/generator.ts';
import { bezierPoint, type Cubic } from '../math/bezier.ts';
import { handlesOf, projectedHandlesOf, sectionFrame } from '../math/frames.ts';
import { add, type Mat3, multiply, transform, transformTransposed, type Vec3 } from '../math/vec3.ts';

/** How a branch leaves its parent, in radians: around it, away from it, and about its own axis. */
export interface AttachAngles {
  theta: number;
  alpha: number;
  roll: number;
}

const sectionAt = (parent: Cubic, o: Vec3, v: number, projected: boolean): Mat3 =>
  sectionFrame(parent, projected ? projectedHandlesOf(parent, o) : handlesOf(parent, o), v);

/** Rx(theta) Rz(alpha) Rx(roll): the branch's axes in the section frame (U, T^, S^) of its parent. Source: Skjermo 2007, 4.2. */
export const rotationOfAngles = ({ theta, alpha, roll }: AttachAngles): Mat3 =>
  multiply(multiply(aboutX(theta), aboutZ(alpha)), aboutX(roll));

/**
 * A branch placed on its parent at v by angles, the paper's way: control points `local` in the branch's own axes (x along), their
 * place in tree space, those axes R, and the orientation vector O, which stays smooth where alpha passes 0.
 * Source: Skjermo 2007, 4.2 (errata E11, E33, E34); equations.md section 4.
 */
export function attachByAngles(
  parent: Cubic,
  parentO: Vec3,
  v: number,
  angles: AttachAngles,
  local: Cubic,
  projected = false,
): { curve: Cubic; o: Vec3; axes: Mat3 } {
  const section = sectionAt(parent, parentO, v, projected);
  const axes = multiply(section, rotationOfAngles(angles));
  const at = bezierPoint(parent, v);
  const place = (p: Vec3): Vec3 => add(at, transform(axes, p));
  const { theta, alpha } = angles;
  // O = sin(alpha) U - cos(alpha) V with V = cos(theta) T^ + sin(theta) S^.
  const o = transform(section, [
    Math.sin(alpha),
    -Math.cos(alpha) * Math.cos(theta),
    -Math.cos(alpha) * Math.sin(theta),
  ]);
  return {
    curve: { p0: place(local.p0), p1: place(local.p1), p2: place(local.p2), p3: place(local.p3) },
    o,
    axes,
  };
}

/**
 * The angles that give a branch the axes `rest` on its parent at v: the inverse of `attachByAngles`, for every rotation.
 * Where the branch lies along the parent theta is 0. Source: equations.md section 4.
 */
export function decomposeAttachment(
  parent: Cubic,
  parentO: Vec3,
  v: number,
  rest: Mat3,
  projected = false,
): AttachAngles {
  const section = sectionAt(parent, parentO, v, projected);
  const m = rest.map((column) => transformTransposed(section, column)) as Mat3;
  const alpha = Math.acos(Math.min(Math.max(m[0][0], -1), 1));
  if (Math.sin(alpha) < 1e-6) {
    const rolled = multiply(aboutZ(-alpha), m);
    return { theta: 0, alpha, roll: Math.atan2(rolled[1][2], rolled[1][1]) };
  }
  return { theta: Math.atan2(m[0][2], m[0][1]), alpha, roll: Math.atan2(m[2][0], -m[1][0]) };
}

/**
 * The angles of a Weber & Penn child that is turned by `rotate` about its parent's axis and tilted by `down`; radians.
 * Source: equations.md section 4.
 */
export const anglesOfWeberPenn = (rotate: number, down: number): AttachAngles => ({
  theta: rotate + Math.PI,
  alpha: down,
  roll: 0,
});
