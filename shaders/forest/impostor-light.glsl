// How a far tree answers the sun: a texel stands for many leaves, some of them in the shade of others and all of them turned otherwise.

// Mean length of the sum of the normals of leaves that a texel shows.
const float FAR_ALIKE = 0.72;

// Is this leaf lit of which a share `lit` are?
float farLit(float lit) {
  return mix(lit, step(fract(farLeaf.x * 7.0 + farLeaf.z), lit), 0.85 * farRough);
}

// Mean over leaves about the normal of what they catch of a light whose cosine is x with it.
float farCatch(float x) {
  float alike = mix(FAR_ALIKE, 0.96, farRough);
  float y = alike * x;
  float s = 0.5 * (1.0 - alike);
  return 0.5 * (y + sqrt(y * y + s * s));
}

// Metres that light along d, tree space, has come through the ellipsoid of the crown.
float farWay(vec3 d) {
  vec3 q = (farPoint - vCrown.xyz) / vCrownRadii.xyz;
  vec3 m = d / vCrownRadii.xyz;
  float a = dot(m, m);
  float b = dot(q, m);
  float c = dot(q, q) - 1.0;
  float root = b * b - a * c;
  if (root <= 0.0) return 0.0;
  root = sqrt(root);
  return max(0.0, root - b - max(-root - b, 0.0)) / a;
}

void RE_Direct_Far(
  const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  float lit = farLit(exp(-vCrownRadii.w * farWay(directLight.direction * vTreeView)));
  float facing = dot(geometryNormal, directLight.direction);
  vec3 light = directLight.color * lit;
  reflectedLight.directDiffuse += light * farCatch(facing) * BRDF_Lambert(material.diffuseContribution);
  float behind = farCatch(-facing);
  float towards = saturate(-dot(geometryViewDir, directLight.direction));
  towards *= towards;
  float through = 0.5 * behind + 0.5 * towards * towards * (0.35 + 0.65 * behind);
  reflectedLight.directDiffuse += light * vThrough.rgb * (farLeaves() * through * farSky * RECIPROCAL_PI);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Far
