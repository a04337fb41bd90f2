// The shadow map as far as it reaches; towards its edge, and beyond, the shade that was splatted over the whole ground.
#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)
float terrainShadow(SHADOW_MAP map, vec2 size, float intensity, float bias, float radius, vec4 coord) {
  vec2 away = abs(coord.xy / coord.w * 2.0 - 1.0);
  float beyond = smoothstep(0.72, 0.96, max(away.x, away.y));
  float far = mix(1.0, terrainLight.x, terrainAir.y);
  if (beyond >= 1.0) return far;
  return mix(getShadow(map, size, intensity, bias, radius, coord), far, beyond);
}
#define getShadow terrainShadow
#endif
