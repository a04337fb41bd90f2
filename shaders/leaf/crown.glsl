#ifndef LEAF_CROWN
#define LEAF_CROWN
// The crown as an ellipsoid: how deep inside it a point lies, and which way is out.

uniform vec3 crownCentre;
uniform vec3 crownRadii;

// Light of the sky that reaches a point: least near the centre and below, all of it outside.
float crownSky(vec3 p) {
  vec3 d = (p - crownCentre) / crownRadii;
  float depth = smoothstep(0.15, 1.0, length(d));
  return mix(0.45, 1.0, depth) * mix(0.8, 1.0, smoothstep(-1.1, 0.5, d.z));
}

// Normal of the ellipsoid through the point, in tree space.
vec3 crownNormal(vec3 p) {
  vec3 d = (p - crownCentre) / (crownRadii * crownRadii);
  return d / max(length(d), 1e-6);
}
#endif
