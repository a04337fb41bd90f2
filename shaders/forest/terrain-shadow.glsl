// The shadow map as far as it reaches; towards its edge, and beyond, the shade that was splatted over the whole ground.
#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)
float terrainShadow(SHADOW_MAP map, vec2 size, float intensity, float bias, float radius, vec4 coord) {
  vec2 away = abs(coord.xy / coord.w * 2.0 - 1.0);
  float beyond = smoothstep(0.72, 0.96, max(away.x, away.y));
  float far = mix(1.0, terrainLight.x, terrainAir.y);
#ifdef TERRAIN_LOOKS
  // Three's five looks on a disc turned by the pixel, with one sine and one cosine in place of five; and none where none is asked for:
  // compilers may take both ways of a branch, but no turn of a loop that is not due.
  vec3 at = coord.xyz / coord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
  at.z -= bias;
#else
  at.z += bias;
#endif
  float phi = interleavedGradientNoise(gl_FragCoord.xy) * PI2;
  vec2 way = vec2(cos(phi), sin(phi));
  // Turned by the golden angle from look to look.
  const mat2 golden = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);
  vec2 rim = radius / size;
  int looks = beyond < 1.0 && at.z <= 1.0 ? 5 : 0;
  float near = looks > 0 ? 0.0 : 1.0;
  for (int i = 0; i < looks; i++) {
    near += 0.2 * texture(map, vec3(at.xy + rim * way * sqrt(0.2 * float(i) + 0.1), at.z));
    way = golden * way;
  }
  return mix(mix(1.0, near, intensity), far, beyond);
#else
  if (beyond >= 1.0) return far;
  return mix(getShadow(map, size, intensity, bias, radius, coord), far, beyond);
#endif
}
#define getShadow terrainShadow
#endif
