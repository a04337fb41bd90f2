// What leaves make of the light of the sky, in place of three's own answer: theirs has no table of what rough surfaces mirror.
#include /leaf/matter.glsl
#ifndef USE_ENVMAP
void RE_IndirectDiffuse_Leaf(
  const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  reflectedLight.indirectDiffuse += irradiance * (LEAF_ENTERS * RECIPROCAL_PI) * material.diffuseColor;
}
#undef RE_IndirectDiffuse
#define RE_IndirectDiffuse RE_IndirectDiffuse_Leaf
#endif
