#ifndef LEAF_MATTER
#define LEAF_MATTER
// What light does at a leaf, near by and far off, without three's table of what rough surfaces mirror.
// Part of the light that is not mirrored at the surface.
#define LEAF_ENTERS 0.95
// What a dielectric mirrors of a light, over the light that falls on it: GGX with the visibility of Kelemen and Szirmay-Kalos (2001, "A
// microfacet based coupled specular-matte BRDF model") and Schlick's term as a product: no root and no power.
float gloss(vec3 light, vec3 eye, vec3 normal, float roughness) {
  vec3 between = normalize(light + eye);
  float facing = dot(normal, between);
  float open = saturate(dot(light, between));
  float a2 = roughness * roughness;
  a2 *= a2;
  float spread = facing * facing * (a2 - 1.0) + 1.0;
  float aslant = 1.0 - open;
  float aslant2 = aslant * aslant;
  return (0.04 + 0.96 * aslant2 * aslant2 * aslant) * (0.25 * RECIPROCAL_PI) * a2 / (spread * spread * max(open * open, 0.05));
}
#endif
