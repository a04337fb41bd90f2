// How a leaf answers to light: three's own answer for dielectrics without its table of what rough surfaces mirror, and with what comes
// through: a crown is many leaves deep, and each of them is lit.
// LEAF_THROUGH: colour of what comes through, and how much of the light gets there.
#ifndef LEAF_THROUGH
#define LEAF_THROUGH (vLeafThrough * (leafClear * vLeaf.y))
#endif
#include /leaf/answer.glsl
#include /leaf/indirect.glsl
void RE_Direct_Leaf(
  const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  vec3 answer = leafAnswer(directLight.direction, geometryViewDir, geometryNormal, material.roughness);
  reflectedLight.directSpecular += directLight.color * answer.y;
  reflectedLight.directDiffuse += directLight.color * (answer.x * material.diffuseColor + answer.z * LEAF_THROUGH);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Leaf
