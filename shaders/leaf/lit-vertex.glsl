#ifdef LEAF_AT_CORNERS
// Light at the corners of leaves. Near by, pixels look for the sun's shadow and veins themselves.
#include /leaf/answer.glsl
#include /leaf/face.glsl
#include <lights_pars_begin>
uniform float roughness;
#ifdef LEAF_NEAR
// Light of the sky | what the leaf makes of the sun's, see leafAnswer.
out vec3 vLeafSky;
out vec3 vLeafSun;
#else
out vec3 vLeafLit;
#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
uniform highp sampler2DShadow directionalShadowMap[NUM_DIR_LIGHT_SHADOWS];
#endif

// Part of the sun's light that gets to this corner, as three's getShadow finds it with one look.
float leafSunlit() {
#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  vec3 place = vDirectionalShadowCoord[0].xyz / vDirectionalShadowCoord[0].w;
  place.z += directionalLightShadows[0].shadowBias;
  bool within = receiveShadow && all(greaterThanEqual(place.xy, vec2(0.0))) && all(lessThanEqual(place, vec3(1.0)));
  if (!within) return 1.0;
  return mix(1.0, textureLod(directionalShadowMap[0], place, 0.0), directionalLightShadows[0].shadowIntensity);
#else
  return 1.0;
#endif
}
#endif

// normal: to shade with; position: in view space; front: is the upper face seen?
void lightLeaf(vec3 normal, vec3 position, bool front) {
  vec3 sky = getAmbientLightIrradiance(ambientLightColor);
#if NUM_HEMI_LIGHTS > 0
  for (int i = 0; i < NUM_HEMI_LIGHTS; i++) sky += getHemisphereLightIrradiance(hemisphereLights[i], normal);
#endif
  sky *= LEAF_ENTERS * RECIPROCAL_PI * vLeaf.y;
  vec3 sun = vec3(0.0);
#if NUM_DIR_LIGHTS > 0
  vec3 eye = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-position);
  // Three keeps all surfaces as rough as this at least.
  sun = leafAnswer(directionalLights[0].direction, eye, normal, max(roughness, 0.045));
  sun.z *= vLeaf.y;
#endif
#ifdef LEAF_NEAR
  vLeafSky = sky;
  vLeafSun = sun;
#else
  vec3 c = leafFace(vLeafTint.rgb, front);
  vLeafLit = c * sky;
#if NUM_DIR_LIGHTS > 0
  vLeafLit += directionalLights[0].color * leafSunlit() * (c * sun.x + sun.y + vLeafThrough * sun.z);
#endif
#endif
}
#endif
