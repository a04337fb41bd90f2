#ifndef BRANCH_COLLAR
#define BRANCH_COLLAR
// Factor of the swelling where a stem leaves its parent, and its slope by metres along the stem: joints look grown, and the
// gap that a round base leaves on a round parent closes. It ends three radii outside the parent.
// along: metres from the base on the parent's axis; radius: of the stem there; parent: the parent's radius, 0 for a trunk.
// amount: how much wider the base is than the stem, 0 for none. Never wider than the parent.
// Twin: src/core/deform/collar.ts
vec2 collar(float along, float radius, float parent, float amount) {
  float reach = parent + 3.0 * radius;
  float e = 1.0 - along / max(reach, 1e-9);
  float most = min(amount, parent / max(radius, 1e-9) - 1.0);
  if (e <= 0.0 || most <= 0.0) return vec2(1.0, 0.0);
  return vec2(1.0 + most * e * e, -2.0 * most * e / reach);
}
#endif
