#include /wind/gust.glsl

in vec4 vFront;
flat in vec4 vGust;
out vec4 fragment;

uniform vec3 forceColour;
uniform vec3 forceGlow;
uniform float overlayAlpha;
uniform vec2 frontReach;

void main() {
  float since = vFront.x;
  float body = gustEnvelope(since, vGust.z, vGust.w);
  // A bright brim where it begins: the eye follows an edge, not a slope.
  float brim = (1.0 - smoothstep(0.0, 0.4 * vGust.z + 0.1, since)) * smoothstep(0.0, 0.03, since);
  float edge = 1.0 - smoothstep(0.45, 1.0, length(vFront.zw) / frontReach.x);
  float hard = vGust.x / (vGust.x + 0.25);
  float alpha = (0.32 * body + 0.4 * brim) * gustWidth(vFront.y, vGust.y) * edge * mix(0.5, 1.0, hard);
  fragment = vec4(mix(forceColour, forceGlow, brim), alpha * overlayAlpha);
}
