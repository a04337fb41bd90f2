/** Elements of a mass of stems, and of a mass of leaf polygons. Source: Weber & Penn 1995, section 5. */
export const STEM_MASS = 16;
export const LEAF_MASS = 4;

/**
 * Elements that the paper's loop draws: of each mass of `mass` the first `number`, and one more in the first masses by the fraction
 * of it. Source: Weber & Penn 1995, section 5; the loop's end is exclusive, the last mass may be a part of one (equations.md 6.9).
 */
export function massesDrawn(total: number, mass: number, number: number): number {
  const whole = Math.floor(number + 1e-9);
  const masses = total / mass;
  const change = masses * (number - whole);
  let drawn = 0;
  for (let m = 0; m < masses; m++) {
    const take = whole + (m < change - 1e-9 ? 1 : 0);
    drawn += Math.min(take, total - m * mass);
  }
  return drawn;
}
