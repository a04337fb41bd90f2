import { arcLength, type Cubic } from '../../core/math/bezier.ts';
import { add, length, scale, subtract, type Vec3 } from '../../core/math/vec3.ts';
import { bendPiece, bendWeights, type Push, paperBendStep, weightedPush } from '../../core/wind/bend.ts';

/** The forms of equation 17. */
export type StepForm = 'printed' | 'units' | 'ours';

/** Equation 17 to the letter: P_i' = P'_(i-1) + (e + b_i)/|e|, every edge about a metre long (erratum E29). */
export function printedStep({ p0, p1, p2, p3 }: Cubic, push: Push): Cubic {
  const step = (from: Vec3, edge: Vec3, b: Vec3): Vec3 => add(from, scale(add(edge, b), 1 / length(edge)));
  const q2 = step(p1, subtract(p2, p1), push.second);
  return { p0, p1, p2: q2, p3: step(q2, subtract(p3, p2), push.third) };
}

/** A whole branch bent by `b` (a change of direction, horizontal) in one of the forms. */
export function bentBranch(rest: Cubic, b: Vec3, form: StepForm): Cubic {
  const push = weightedPush(b, bendWeights(0, 1));
  if (form === 'printed') return printedStep(rest, push);
  return form === 'units' ? paperBendStep(rest, push) : bendPiece(rest, push, arcLength(rest));
}

/** A branch that stands upright, `long` metres, with a slight curve `lean` (0: straight). */
export const uprightBranch = (long: number, lean: number): Cubic => {
  const l = long / 3;
  const tilted = (angle: number): Vec3 => [l * Math.sin(angle), 0, l * Math.cos(angle)];
  const p1: Vec3 = [0, 0, l];
  const p2 = add(p1, tilted(-lean));
  return { p0: [0, 0, 0], p1, p2, p3: add(p2, tilted(-2 * lean)) };
};
