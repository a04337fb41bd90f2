// What a leaf's colour needs: x the leaf's own number 0..1, y light of the sky, z distance from the midrib, w along it.
#include /leaf/crown.glsl
out vec4 vLeaf;

// How far normals turn from the leaf's own to the crown's, 0..1.
uniform float crownRounding;

// The normal to shade with, in view space: on the side of the eye, and turned towards the crown's outside, so that a crown
// reads as one body under the light (Malheiros & Walter 2011, section 4.2).
vec3 leafShadingNormal(vec3 viewNormal, vec3 viewPosition, vec3 crown, bool parallel) {
  vec3 eye = parallel ? vec3(0.0, 0.0, 1.0) : -viewPosition;
  vec3 n = dot(viewNormal, eye) < 0.0 ? -viewNormal : viewNormal;
  vec3 m = mix(n, crown, crownRounding);
  return dot(m, m) > 1e-4 ? normalize(m) : n;
}
