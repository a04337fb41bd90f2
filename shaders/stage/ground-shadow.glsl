// A shadow is sharp where it begins and soft where it ends: its rim widens with the light's way from what throws it. At a distance
// from the foot, along the shadow, that is about as high as the light is steep.
#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)
float groundShadow(SHADOW_MAP map, vec2 size, float intensity, float bias, float radius, vec4 coord) {
  float along = max(0.0, dot(vGround.xz, groundShade.xy));
  // At a flat angle a pixel covers a long strip of the ground: it is looked at in all of that, or a trunk's shadow, which is less wide, would be dashes.
  vec4 side = dFdx(coord);
  vec4 strip = dFdy(coord);
  if (length(side.xy) > length(strip.xy)) strip = side;
  float texels = length(strip.xy * size);
  float rim = clamp(max(along * groundShade.z * groundShade.w, 0.2 * texels), radius, 9.0);
  float all = getShadow(map, size, intensity, bias, rim, coord);
  if (texels > 5.0) {
    strip *= 0.33;
    all += getShadow(map, size, intensity, bias, rim, coord + strip) + getShadow(map, size, intensity, bias, rim, coord - strip);
    all /= 3.0;
  } else if (rim > 2.0) {
    // The five samples of a wide rim show: five more, between them.
    all = 0.5 * (all + getShadow(map, size, intensity, bias, 0.55 * rim, coord));
  }
  return all;
}
#define getShadow groundShadow
#endif
