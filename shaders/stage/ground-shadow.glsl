// A shadow is sharp where it begins and soft where it ends: its rim widens with the light's way from what throws it. At a distance
// from the foot, along the shadow, that is about as high as the light is steep.
#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)
float groundShadow(SHADOW_MAP map, vec2 size, float intensity, float bias, float radius, vec4 coord) {
  float along = max(0.0, dot(vGround.xz, groundShade.xy));
  // Where a pixel covers more of the ground than a trunk's shadow is wide, it is seen through all of it, or the shadow would be dashes.
  vec2 pixel = fwidth(coord.xy) * size;
  float rim = clamp(max(along * groundShade.z * groundShade.w, 0.4 * max(pixel.x, pixel.y)), radius, 9.0);
  float all = getShadow(map, size, intensity, bias, rim, coord);
  // The five samples of a wide rim show: five more, between them.
  if (rim > 2.0) all = 0.5 * (all + getShadow(map, size, intensity, bias, 0.55 * rim, coord));
  return all;
}
#define getShadow groundShadow
#endif
