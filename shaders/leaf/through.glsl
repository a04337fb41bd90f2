// Light through a leaf: most where the sun stands on its other side, and more when one looks towards the sun.
// Wraps the material's own answer to a light, so shadows dim it as well. LEAF_THROUGH: its colour, and how much of the light gets there.
#ifndef LEAF_THROUGH
#define LEAF_THROUGH (vLeafThrough * (leafClear * vLeaf.y))
#endif
void RE_Direct_Leaf(
  const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  RE_Direct_Physical(
    directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight
  );
  float behind = saturate(-dot(geometryNormal, directLight.direction));
  float towards = saturate(-dot(geometryViewDir, directLight.direction));
  towards *= towards;
  float through = 0.5 * behind + 0.5 * towards * towards * (0.35 + 0.65 * behind);
  reflectedLight.directDiffuse += directLight.color * LEAF_THROUGH * (through * RECIPROCAL_PI);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Leaf
