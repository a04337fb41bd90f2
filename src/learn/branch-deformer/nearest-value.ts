/** The value of a control at which something comes nearest: what a handle does whose way is no straight line. */
export function nearestValue(min: number, max: number, step: number, distance: (value: number) => number): number {
  let best = min;
  let least = Number.POSITIVE_INFINITY;
  for (let value = min; value <= max + 1e-9; value += step) {
    const far = distance(value);
    if (far < least) [best, least] = [value, far];
  }
  return best;
}
