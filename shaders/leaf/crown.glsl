#ifndef LEAF_CROWN
#define LEAF_CROWN
#pragma grove_tree
// Light inside the crown, as src/core/look/crown-light.ts finds it from where the leaves are, and which way is out of it.

uniform highp sampler3D crownLight;
// Box of the grid: its least corner and its size, metres in tree space; in a grove radii of the crown about its centre, the tree's own axes.
uniform vec3 crownLow;
uniform vec3 crownSize;
#ifndef GROVE
uniform vec3 crownCentre;
uniform vec3 crownRadii;
#endif

// Light of the sky that reaches a point, 0..1: least deep inside and below, all of it outside.
float crownSky(vec3 p) {
#ifdef GROVE
  p = inCrown(p);
#endif
  return textureLod(crownLight, (p - crownLow) / crownSize, 0.0).r;
}

// Normal of the crown's ellipsoid through the point, in tree space.
vec3 crownNormal(vec3 p) {
#ifdef GROVE
  vec3 d = fromTree(inCrown(p) / treeTexel(TREE_RADII).xyz);
#else
  vec3 d = (p - crownCentre) / (crownRadii * crownRadii);
#endif
  return d / max(length(d), 1e-6);
}
#endif
