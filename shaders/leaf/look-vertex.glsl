// What a leaf's colour needs.
#include /leaf/crown.glsl
#include /leaf/ramp.glsl

// How near to the margin, -1 on the stalk | light of the sky | distance from the midrib | along it.
out vec4 vLeaf;
// Its upper face | how far it has turned to the second colour. One number a leaf: nothing to interpolate.
flat out vec4 vLeafTint;
// Light that comes through.
flat out vec3 vLeafThrough;

// How far normals turn from the leaf's own to the crown's, 0..1.
uniform float crownRounding;
uniform float leafVariation;
// Part of the leaves that are on their way to the second colour.
uniform float leafTurned;
// Light that a blade lets through, 1 for one of common thickness.
uniform float leafThin;

// Twin: leafColour, throughColour of src/core/look/leaf-look.ts. own: the leaf's own number, 0..1.
void leafColours(float own) {
  float turned = leafTurn(own, leafTurned);
  float value = 1.0 + leafVariation * (fract(own * 7.31) - 0.5) * 1.1;
  // Some leaves are younger and yellower, few are old and dull; some are warmer than others.
  float young = leafVariation * fract(own * 13.7) * (1.0 - turned);
  float warm = leafVariation * (fract(own * 31.7) - 0.5);
  vec3 face = leafRamp(turned);
  vec3 c = mix(face, leafGlow, young * 0.8) * value * vec3(1.0 + 0.35 * warm, 1.0, 1.0 - 0.35 * warm);
  vLeafTint = vec4(c, turned);
  vLeafThrough = mix(mix(leafGlow, leafSecond * 1.3, turned), face * 1.6, 0.4) * (value * leafThin);
}

// The normal to shade with, in view space: on the side of the eye, and turned towards the crown's outside, so that a crown
// reads as one body under the light (Malheiros & Walter 2011, section 4.2).
vec3 leafShadingNormal(vec3 viewNormal, vec3 viewPosition, vec3 crown, bool parallel) {
  vec3 eye = parallel ? vec3(0.0, 0.0, 1.0) : -viewPosition;
  vec3 n = dot(viewNormal, eye) < 0.0 ? -viewNormal : viewNormal;
  vec3 m = mix(n, crown, crownRounding);
  return dot(m, m) > 1e-4 ? normalize(m) : n;
}
