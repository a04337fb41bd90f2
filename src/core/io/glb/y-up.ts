/** Tree space has z up, glTF y: a quarter turn about x takes (x, y, z) to (x, z, -y). */

/** Vectors of 3 or 4 numbers, turned; a fourth number stays. */
export function yUp(vectors: Float32Array, size: 3 | 4 = 3): Float32Array<ArrayBuffer> {
  const out = new Float32Array(vectors.length);
  for (let i = 0; i < vectors.length; i += size) {
    out[i] = vectors[i]!;
    out[i + 1] = vectors[i + 2]!;
    out[i + 2] = -vectors[i + 1]!;
    if (size === 4) out[i + 3] = vectors[i + 3]!;
  }
  return out;
}

/** Rotations (x, y, z, w) that lead to y-up space where they led to tree space. */
export function yUpRotations<Numbers extends Float32Array | Float64Array>(rotations: Numbers): Numbers {
  const out = rotations.slice() as Numbers;
  const half = Math.SQRT1_2;
  for (let i = 0; i < rotations.length; i += 4) {
    const [x, y, z, w] = [rotations[i]!, rotations[i + 1]!, rotations[i + 2]!, rotations[i + 3]!];
    // (-sqrt 1/2, 0, 0, sqrt 1/2) times the rotation.
    out[i] = half * (x - w);
    out[i + 1] = half * (y + z);
    out[i + 2] = half * (z - y);
    out[i + 3] = half * (w + x);
  }
  return out;
}

/** Joints (position, rotation: 7 numbers each), turned. */
export function yUpJoints(joints: Float64Array): Float64Array {
  const out = joints.slice();
  for (let i = 0; i < joints.length; i += 7) {
    out[i + 1] = joints[i + 2]!;
    out[i + 2] = -joints[i + 1]!;
    out.set(yUpRotations(joints.subarray(i + 3, i + 7)), i + 3);
  }
  return out;
}
