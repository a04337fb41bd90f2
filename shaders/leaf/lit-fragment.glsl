#ifdef LEAF_AT_CORNERS
#ifdef LEAF_NEAR
in vec3 vLeafSky;
in vec3 vLeafSun;
#else
in vec3 vLeafLit;
#endif

// Light of a leaf of colour c, whose corners were lit.
vec3 leafLit(vec3 c) {
#ifdef LEAF_NEAR
  vec3 light = c * vLeafSky;
#if NUM_DIR_LIGHTS > 0
  vec3 sun = directionalLights[0].color * (c * vLeafSun.x + vLeafSun.y + vLeafThrough * (leafClear * vLeafSun.z));
#if defined(USE_SHADOWMAP) && NUM_DIR_LIGHT_SHADOWS > 0
  DirectionalLightShadow map = directionalLightShadows[0];
  if (receiveShadow) {
    sun *= getShadow(
      directionalShadowMap[0], map.shadowMapSize, map.shadowIntensity, map.shadowBias, map.shadowRadius, vDirectionalShadowCoord[0]
    );
  }
#endif
  light += sun;
#endif
  return light;
#else
  return c * vLeafLit;
#endif
}
#endif
