#ifndef LEAF_RAMP
#define LEAF_RAMP
// How leaves turn from their colour to the second one. Twin: src/core/look/leaf-look.ts

uniform vec3 leafColour;
uniform vec3 leafGlow;
uniform vec3 leafSecond;

// The upper face of a leaf that has turned by t, 0..1: green does not become red but by way of what shines through it.
vec3 leafRamp(float t) {
  vec3 between = mix(0.5 * (leafColour + leafSecond), leafGlow, 0.4);
  return t < 0.5 ? mix(leafColour, between, 2.0 * t) : mix(between, leafSecond, 2.0 * t - 1.0);
}

// How far a leaf has turned, 0..1, where `share` of all are on their way; own: its number, 0..1.
float leafTurn(float own, float share) {
  return smoothstep(0.0, 1.0, (1.45 * share - fract(own * 23.93)) / 0.45);
}
#endif
