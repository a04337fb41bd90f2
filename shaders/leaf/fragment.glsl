// Colour of a leaf: upper and lower face, how far it has turned, and veins near by.
#include /leaf/lit.glsl
in vec4 vLeaf;
flat in vec4 vLeafTint;
flat in vec3 vLeafThrough;
#include /leaf/face.glsl

// What veins leave of the light that comes through.
float leafClear = 1.0;

#ifdef LEAF_VEINS
#include /leaf/ramp.glsl
#include /leaf/veins.glsl
#endif

vec3 leafDiffuse(bool front) {
  vec3 c = vLeafTint.rgb;
#ifdef LEAF_VEINS
  float turned = vLeafTint.w;
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
  return leafFace(c, front);
}
