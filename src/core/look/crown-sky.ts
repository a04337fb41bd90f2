const smoothstep = (a: number, b: number, x: number): number => {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
};

/**
 * Light of the sky that reaches a point of a crown, 0..1: least near the centre and below, all of it outside. `crown`: centre and
 * radii (PackedTree.crown); tree space. As shaders/leaf/crown.glsl has it.
 */
export function crownSky(crown: ArrayLike<number>, x: number, y: number, z: number): number {
  const dx = (x - crown[0]!) / crown[3]!;
  const dy = (y - crown[1]!) / crown[4]!;
  const dz = (z - crown[2]!) / crown[5]!;
  const depth = smoothstep(0.15, 1, Math.sqrt(dx * dx + dy * dy + dz * dz));
  return (0.45 + 0.55 * depth) * (0.8 + 0.2 * smoothstep(-1.1, 0.5, dz));
}

/** Writes the normal of the crown's ellipsoid through a point to `out`. */
export function crownNormal(crown: ArrayLike<number>, x: number, y: number, z: number, out: Float64Array): void {
  out[0] = (x - crown[0]!) / (crown[3]! * crown[3]!);
  out[1] = (y - crown[1]!) / (crown[4]! * crown[4]!);
  out[2] = (z - crown[2]!) / (crown[5]! * crown[5]!);
  const n = 1 / Math.max(Math.sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]), 1e-6);
  out[0] *= n;
  out[1] *= n;
  out[2] *= n;
}
