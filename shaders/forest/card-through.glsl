// Light through the leaves of a clump, as through.glsl of the leaves has it.
void RE_Direct_Card(
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
  reflectedLight.directDiffuse += directLight.color * cardThrough * (through * vCardCrown.w * RECIPROCAL_PI);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Card
