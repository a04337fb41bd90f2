import { addScaled, length, type Mat3, mix, transformTransposed, type Vec3 } from '../math/vec3.ts';

/** Steps a second on which the state of the springs lives. */
export const SPRING_RATE = 60;

/** One step of an oscillator less the identity, for x = q - target: q' = q + b11 x + b12 v, v' = v + b21 x + b22 v. */
export type Transition = [b11: number, b12: number, b21: number, b22: number];

/**
 * The exact step over `dt` seconds of x'' = -omega^2 x - 2 damping omega x', less the identity; `damping` is the ratio to the
 * critical one, below, at or above 1. So any stiffness is stable at any step, and a step that is repeated follows the closed form.
 * Differences from the identity: small steps keep their digits in float32. Source: the closed form of the damped oscillator.
 */
export function springTransition(omega: number, damping: number, dt: number): Transition {
  const a = damping * omega * dt;
  const [c, s] = swing((damping - 1) * (damping + 1) * (omega * dt) ** 2, a);
  // c and s are e^-a times the cosine and times sin(w)/w, w = omega dt sqrt(1 - damping^2), of which both are even functions.
  return [c + a * s, s * dt, -omega * omega * dt * s, c - a * s];
}

/** e^-a cosh(sqrt(square)) - 1 and e^-a sinh(sqrt(square))/sqrt(square); cosine and sine where `square` is negative. */
function swing(square: number, a: number): [lessOne: number, s: number] {
  const fade = Math.exp(-a);
  if (square > 1) {
    const root = Math.sqrt(square);
    // Of two exponentials, since e^root alone may overflow.
    const slow = Math.exp(root - a);
    const quick = Math.exp(-root - a);
    return [(slow + quick) / 2 - 1, (slow - quick) / (2 * root)];
  }
  if (square < -1) {
    const root = Math.sqrt(-square);
    return [fade * Math.cos(root) - 1, (fade * Math.sin(root)) / root];
  }
  // Near the critical damping, and for short steps: the series, and c - 1 without the loss of digits that a difference has.
  let c = 0;
  let s = 1;
  let term = 1;
  for (let n = 1; n < 12; n++) {
    term *= square / ((2 * n - 1) * (2 * n));
    c += term;
    s += term / (2 * n + 1);
  }
  return [Math.expm1(-a) + fade * c, fade * s];
}

/** The state of one piece, as a texel of each of STATE_TARGETS holds it. Twin: shaders/wind/spring.glsl. */
export interface Spring {
  /** Bend along T and S of the frame at rest. */
  q: [number, number];
  /** Its velocity, 1/s. */
  velocity: [number, number];
  /** Acceleration of the piece's base and of its end, m/s^2, tree space. */
  base: Vec3;
  end: Vec3;
  /** |F|, metres. */
  force: number;
  /** Bend along L: the pull of the wind along the branch, which does not swing. */
  along: number;
}

/**
 * What the bend of a piece strives for, along the columns L, T and S of its frame at rest: the wind's bend `beta`, less what the
 * acceleration of its base (m/s^2) throws it back; that is at most 1. `lever`: SPRING_LAYERS.LOAD's times the wind's inertia.
 * Source: a rod on a hinge that is shaken: angle = 1.5 a/(L omega^2). Twin: shaders/wind/spring.glsl.
 */
export function springTarget(frame: Mat3, beta: Vec3, acceleration: Vec3, lever: number): Vec3 {
  const [, at, as] = transformTransposed(frame, acceleration);
  const thrown = lever / Math.max(1, Math.abs(lever) * Math.sqrt(at * at + as * as));
  const [l, t, s] = transformTransposed(frame, beta);
  return [l, t - thrown * at, s - thrown * as];
}

/** The state at time 0: at the target, not moving. `force`: |F| in metres. Twin: shaders/wind/spring.glsl. */
export const springStart = (target: Vec3, force: number): Spring => ({
  q: [target[1], target[2]],
  velocity: [0, 0],
  base: [0, 0, 0],
  end: [0, 0, 0],
  force,
  along: target[0],
});

/**
 * One step towards a target that stands still meanwhile, exactly. `base`: acceleration of the piece's base; `reach`: how far a bend
 * of 1 moves its end, metres. Twin: shaders/wind/spring.glsl.
 */
export function springStep(
  { q, velocity }: Pick<Spring, 'q' | 'velocity'>,
  target: Vec3,
  [b11, b12, b21, b22]: Transition,
  frame: Mat3,
  base: Vec3,
  reach: number,
  force: number,
): Spring {
  const x = q[0] - target[1];
  const y = q[1] - target[2];
  const fasterX = b21 * x + b22 * velocity[0];
  const fasterY = b21 * y + b22 * velocity[1];
  const r = SPRING_RATE * reach;
  return {
    q: [q[0] + b11 * x + b12 * velocity[0], q[1] + b11 * y + b12 * velocity[1]],
    velocity: [velocity[0] + fasterX, velocity[1] + fasterY],
    base,
    end: addScaled(addScaled(base, frame[1], fasterX * r), frame[2], fasterY * r),
    force,
    along: target[0],
  };
}

const mixPair = (a: readonly number[], b: readonly number[], f: number): [number, number] => [
  a[0] * (1 - f) + b[0] * f,
  a[1] * (1 - f) + b[1] * f,
];

/** The state between two steps. Twin: shaders/wind/spring.glsl. */
export const mixSpring = (a: Spring, b: Spring, f: number): Spring => ({
  q: mixPair(a.q, b.q, f),
  velocity: mixPair(a.velocity, b.velocity, f),
  base: mix(a.base, b.base, f),
  end: mix(a.end, b.end, f),
  force: a.force * (1 - f) + b.force * f,
  along: a.along * (1 - f) + b.along * f,
});

/** The bend of a state along L, T and S, for `framePush`. Twin: shaders/wind/spring.glsl. */
export const springBend = ({ along, q }: Spring): Vec3 => [along, q[0], q[1]];

/**
 * How hard the leaves are shaken, metres of force: by the wind, and by a tenth of a second of the branch's own way. `third`: of the
 * stem's length, metres. Twin: shaders/wind/spring.glsl.
 */
export const springStir = ({ force, velocity }: Spring, third: number): number =>
  force + 0.1 * third * length([velocity[0], velocity[1], 0]);
