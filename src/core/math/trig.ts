/**
 * The sine of a quarter turn or less, as an odd polynomial of six terms (minimax, 1.4e-11 off; 2e-7 in float32).
 * Software GL's own sine is off by 2e-4; this one is the same in both languages.
 */
export const sineOfQuarter = (y: number): number => {
  const s = y * y;
  const tail = 41.9999898947871 + s * -14.337025069807426;
  return (
    y * (6.28318530648751 + s * (-41.3417019297741 + s * (81.60520943120132 + s * (-76.70366783199628 + s * tail))))
  );
};

/** Sine of an angle in turns, any size. Twin: shaders/lib/trig.glsl. */
export function sinTurns(x: number): number {
  const r = x - Math.floor(x + 0.5);
  const a = Math.abs(r);
  const s = sineOfQuarter(Math.min(a, 0.5 - a));
  return r < 0 ? -s : s;
}

/** Cosine of an angle in turns, any size. Twin: shaders/lib/trig.glsl. */
export const cosTurns = (x: number): number => sineOfQuarter(0.25 - Math.abs(x - Math.floor(x + 0.5)));

/** x^k for x >= 0 and k > 0, 0 at 0: GLSL leaves pow undefined there. Twin: shaders/lib/trig.glsl. */
export const power = (x: number, k: number): number => (x > 0 ? Math.exp(k * Math.log(x)) : 0);

/**
 * The angle in radians between two unit vectors whose tips are `chord` apart (0..2), within 0.1 % up to 120 degrees.
 * For display: acos loses small angles in float32 and is 7e-5 off on software GL. Twin: shaders/lib/trig.glsl.
 */
export function angleOfChord(chord: number): number {
  const s = chord * chord;
  return chord * (0.99933582 + s * (0.04752513 + s * (-0.00302809 + s * 0.00349376)));
}
