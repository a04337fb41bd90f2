/** One step of the PCG hash on 32 bits (Jarzynski & Olano 2020); an unsigned integer. Twin: shaders/lib/hash.glsl. */
export function hashPcg(value: number): number {
  const state = (Math.imul(value, 747796405) + 2891336453) >>> 0;
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0;
  return ((word >>> 22) ^ word) >>> 0;
}

/** The hash of two unsigned integers: how the path of a stem is made, `combine(parent's path, child's number)`. */
export const combine = (a: number, b: number): number => hashPcg((hashPcg(a) + b) | 0);

/** An unsigned integer to [0, 1), 24 bits, exact in float32. Twin: shaders/lib/hash.glsl. */
export const hashUnit = (hash: number): number => (hash >>> 8) * (1 / 16777216);
