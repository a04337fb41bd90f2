/** The box in which positions are stored in 16 bits: metres = offset + scale q, q in 0..1, the same scale along all axes. */
export interface Quantum {
  readonly offset: readonly [number, number, number];
  readonly scale: number;
}

/** The least cube around positions, 3 each. */
export function quantumOf(arrays: readonly Float32Array[]): Quantum {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (const array of arrays) {
    for (let i = 0; i < array.length; i++) {
      const k = i % 3;
      least[k] = Math.min(least[k]!, array[i]!);
      most[k] = Math.max(most[k]!, array[i]!);
    }
  }
  const sides = most.map((x, k) => x - least[k]!);
  // Numbers that a file holds to the bit.
  return {
    offset: least.map(Math.fround) as [number, number, number],
    scale: Math.fround(Math.max(1e-6, ...sides) * 1.000001),
  };
}

/** Positions in 16 bits. */
export function quantizePositions(positions: Float32Array, { offset, scale }: Quantum): Uint16Array<ArrayBuffer> {
  const out = new Uint16Array(positions.length);
  for (let i = 0; i < positions.length; i++) {
    out[i] = Math.min(65535, Math.max(0, Math.round((65535 * (positions[i]! - offset[i % 3]!)) / scale)));
  }
  return out;
}

/** Unit vectors in 8 bits a part. */
export function quantizeDirections(directions: Float32Array): Int8Array<ArrayBuffer> {
  const out = new Int8Array(directions.length);
  for (let i = 0; i < directions.length; i++) out[i] = Math.round(127 * directions[i]!);
  return out;
}
