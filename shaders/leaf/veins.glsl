#ifndef LEAF_VEIN_PATTERN
#define LEAF_VEIN_PATTERN
// Veins of a blade. Twin: src/core/look/leaf-veins.ts (veinsAt)

// How strongly they show | how they run: 0 none, 1 a midrib with side veins, 2 ribs that spread from the base, 3 along the blade.
uniform vec2 leafVeins;
// Ends of the ribs that spread; as far across as widths go, along in lengths.
uniform vec2 leafLobes[3];

// x: ribs, y: side veins, z: rise between side veins; 0..1 each. x across: 0 on the midrib, 1 at the widest place; z along the blade.
vec3 leafVeinsAt(float x, float z) {
  float rib = 1.0 - smoothstep(0.02, 0.07, x);
  if (leafVeins.y > 2.5) return vec3(0.7 * rib, 0.5 * (1.0 - smoothstep(0.05, 0.2, abs(fract(4.0 * x) - 0.5))), 0.5);
  if (leafVeins.y > 1.5) {
    vec2 p = vec2(0.5 * x, z - 0.03);
    for (int i = 0; i < 3; i++) {
      vec2 d = leafLobes[i] - vec2(0.0, 0.03);
      float along = dot(p, d) / dot(d, d);
      float wide = 0.022 * (1.1 - along);
      float here = (1.0 - smoothstep(0.3 * wide, wide, length(p - along * d))) * step(0.0, along) * step(along, 1.0);
      rib = max(rib, here);
    }
  }
  // Side veins leave the midrib aslant and bend to the tip before they reach the margin.
  float beside = abs(fract((z - x * (0.5 - 0.16 * x)) * 8.0) - 0.5);
  float fade = 1.0 - smoothstep(0.45, 1.0, x);
  return vec3(rib, (1.0 - smoothstep(0.02, 0.1, beside)) * fade, 2.0 * beside);
}
#endif
