#ifndef LEAF_CROWN
#define LEAF_CROWN
// Light inside the crown, as src/core/look/crown-light.ts finds it from where the leaves are, and which way is out of it.

uniform highp sampler3D crownLight;
// Box of the grid: its least corner and its size, metres in tree space.
uniform vec3 crownLow;
uniform vec3 crownSize;
uniform vec3 crownCentre;
uniform vec3 crownRadii;

// Light of the sky that reaches a point, 0..1: least deep inside and below, all of it outside.
float crownSky(vec3 p) {
  return textureLod(crownLight, (p - crownLow) / crownSize, 0.0).r;
}

// Normal of the crown's ellipsoid through the point, in tree space.
vec3 crownNormal(vec3 p) {
  vec3 d = (p - crownCentre) / (crownRadii * crownRadii);
  return d / max(length(d), 1e-6);
}
#endif
