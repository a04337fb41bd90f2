const word = new Uint32Array(1);
const float = new Float32Array(word.buffer);

/** The bits of the half-precision float nearest to a number, ties to even; beyond its range infinity. Source: IEEE 754 binary16. */
export function halfBits(value: number): number {
  float[0] = value;
  const bits = word[0]!;
  const sign = (bits >>> 16) & 0x8000;
  const rest = bits & 0x7fffffff;
  if (rest > 0x7f800000) return 0x7e00;
  // From 65520 on the nearest is beyond the largest.
  if (rest >= 0x477ff000) return sign | 0x7c00;
  if (rest >= 0x38800000) {
    const even = (rest >>> 13) & 1;
    return sign | ((rest - 0x38000000 + 0xfff + even) >>> 13);
  }
  // Below 2^-14 the steps are all 2^-24: adding a half leaves such a number in the last bits of the sum.
  float[0] = Math.abs(value) + 0.5;
  return sign | (word[0]! - 0x3f000000);
}

/** The number that the bits of a half-precision float stand for. */
export function halfValue(bits: number): number {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >>> 10) & 31;
  const part = bits & 1023;
  if (exponent === 31) return part ? Number.NaN : sign * Number.POSITIVE_INFINITY;
  return exponent === 0 ? sign * part * 2 ** -24 : sign * (1 + part / 1024) * 2 ** (exponent - 15);
}
