/**
 * Factor of the swelling where a stem leaves its parent, and its slope by metres along the stem: joints look grown, and the gap
 * that a round base leaves on a round parent closes. It ends three radii outside the parent.
 *
 * `along`: metres from the base on the parent's axis; `radius` of the stem there and `parent`, its parent's (0 for a trunk), in
 * metres; `amount`: how much wider the base is than the stem, 0 for none. Never wider than the parent. Ours, not a paper's.
 * Twin: shaders/branch/collar.glsl.
 */
export function collar(along: number, radius: number, parent: number, amount: number): [factor: number, slope: number] {
  const reach = parent + 3 * radius;
  const e = 1 - along / Math.max(reach, 1e-9);
  const most = Math.min(amount, parent / Math.max(radius, 1e-9) - 1);
  if (e <= 0 || most <= 0) return [1, 0];
  return [1 + most * e * e, (-2 * most * e) / reach];
}
