// Colour of a leaf: upper and lower face, how far it has turned, and veins near by.
in vec4 vLeaf;
flat in vec4 vLeafTint;
flat in vec3 vLeafThrough;

uniform vec3 leafUnder;
uniform vec4 levelTint;

// What veins leave of the light that comes through.
float leafClear = 1.0;

#ifdef LEAF_VEINS
#include /leaf/ramp.glsl
#include /leaf/veins.glsl
#endif

vec3 leafDiffuse(bool front) {
  vec3 c = vLeafTint.rgb;
#ifdef LEAF_ORGAN
  // Petals and their middle, scales and the gaps between them.
  c = mix(c, leafUnder, vLeaf.z);
#else
  float turned = vLeafTint.w;
#ifdef LEAF_VEINS
  if (turned > 0.0 && turned < 1.0) {
    // A leaf turns from its margin inwards.
    float here = clamp(1.9 * turned - 0.9 * (1.0 - max(vLeaf.x, 0.0)), 0.0, 1.0);
    c *= leafRamp(here) / max(leafRamp(turned), 0.004);
  }
  if (leafVeins.y > 0.5) {
    vec3 veins = leafVeinsAt(vLeaf.z, vLeaf.w) * min(2.0 * leafVeins.x, 1.0);
    c *= 1.0 - 0.12 * veins.y + 0.1 * (veins.z - 0.5 * min(2.0 * leafVeins.x, 1.0));
    c = mix(c, c * 1.35 + 0.02, max(veins.x, 0.4 * veins.y));
    leafClear = 1.0 - 0.5 * max(veins.x, 0.6 * veins.y);
  }
#endif
  if (!front) c = mix(c, leafUnder, 0.35 - 0.2 * turned);
  if (vLeaf.x < -0.5) c = mix(c, leafUnder, 0.5);
#endif
  return mix(c, levelTint.rgb, levelTint.a);
}
