// How a far tree answers the sun: a texel stands for many leaves, some of them in the shade of others and all of them turned otherwise.
#include /leaf/indirect.glsl

// Mean length of the sum of the normals of leaves that a texel shows.
const float FAR_ALIKE = 0.72;
// Metres behind the first leaf in which all are lit as it is; how much more is lost behind them than the mean of the crown says.
const float FAR_SLACK = 0.35;
const float FAR_LOST = 1.25;
// Leaves that are turned all ways mirror so much more than one that is turned as they are on the mean.
const float FAR_GLOSS = 1.6;

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

// Metres of the crown that light along d, tree space, has come through: how far the point lies behind what the picture shows that was taken
// from nearest to there. Every tree has the shadow map of its own outline so.
float farWay(vec3 d) {
  vec2 cell = floor((0.5 * hemiOctahedral(d) + 0.5) * (farViews.x - 1.0) + 0.5);
  mat3 frame = viewFrame(viewDirection(cell, farViews.x));
  vec3 p = farPoint * frame;
  float before = textureLod(farShapes, farPlaceOn(0.5 + 0.5 * p.xy / vHalf.xy, cell), vCellC.w).z;
  return vAsideC.z * (1.0 - 2.0 * before) - p.z;
}

void RE_Direct_Far(
  const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal,
  const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material,
  inout ReflectedLight reflectedLight
) {
  float lit = farLit(exp(-FAR_LOST * vHalf.w * max(farWay(directLight.direction * vTreeView) - FAR_SLACK, 0.0)));
  float facing = dot(geometryNormal, directLight.direction);
  vec3 light = directLight.color * lit;
  reflectedLight.directSpecular +=
    light * (FAR_GLOSS * saturate(facing)) * gloss(directLight.direction, geometryViewDir, geometryNormal, material.roughness);
  reflectedLight.directDiffuse += light * farCatch(facing) * (LEAF_ENTERS * RECIPROCAL_PI) * material.diffuseColor;
  float behind = farCatch(-facing);
  float towards = saturate(-dot(geometryViewDir, directLight.direction));
  towards *= towards;
  float through = 0.35 * behind + 0.4 * towards * towards * (0.35 + 0.65 * behind);
  reflectedLight.directDiffuse += light * vThrough.rgb * (farLeaves() * through * farSky * RECIPROCAL_PI);
}
#undef RE_Direct
#define RE_Direct RE_Direct_Far
