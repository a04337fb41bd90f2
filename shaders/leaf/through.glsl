// How a leaf answers to light. Through it comes most where the sun stands on its other side, and more when one looks towards the sun.
// Three's own answer for dielectrics without its table of what rough surfaces mirror: a crown is many leaves deep, and each of them is lit.
// LEAF_THROUGH: colour of what comes through, and how much of the light gets there.
#ifndef LEAF_THROUGH
#define LEAF_THROUGH (vLeafThrough * (leafClear * vLeaf.y))
#endif
#include /leaf/matter.glsl
void RE_Direct_Leaf(
  const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  float facing = dot(geometryNormal, directLight.direction);
  vec3 irradiance = saturate(facing) * directLight.color;
  reflectedLight.directSpecular +=
    irradiance * gloss(directLight.direction, geometryViewDir, geometryNormal, material.roughness);
  reflectedLight.directDiffuse += irradiance * (LEAF_ENTERS * RECIPROCAL_PI) * material.diffuseColor;
  float behind = saturate(-facing);
  float towards = saturate(-dot(geometryViewDir, directLight.direction));
  towards *= towards;
  float through = 0.5 * behind + 0.5 * towards * towards * (0.35 + 0.65 * behind);
  reflectedLight.directDiffuse += directLight.color * LEAF_THROUGH * (through * RECIPROCAL_PI);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Leaf
