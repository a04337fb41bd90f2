// What some kinds of bark are besides their tile: `barkOwnTexel` changes what the tile says, and `barkOwn` the colour of the bark.
#ifdef BARK_FOOT
#define BARK_OWN
// At the foot the paper has burst into black cork, fissured along the stem.
float barkOwnTexel() {
  vec2 rough = vGrowth.xy * vec2(6.0, 1.1);
  float ridge = texture(barkGrowth, rough).w;
  float beside = texture(barkGrowth, rough + vec2(0.02, 0.0)).w;
  float cork = 1.6 * vGrowth.w + 1.5 * (texture(barkGrowth, vGrowth.xy * vec2(3.0, 0.7)).w - 0.5) + 1.5 * (ridge - 0.5);
  float burst = smoothstep(0.72, 0.86, cork);
  barkTexel.x = mix(barkTexel.x, 0.66 + 0.44 * smoothstep(0.32, 0.62, ridge) - 0.12 * barkTexel.w, burst);
  barkTexel.y = mix(barkTexel.y, clamp(0.5 + 2.2 * (beside - ridge), 0.08, 0.92), burst);
  return 0.0;
}

vec3 barkOwn(vec3 bark, float own) {
  return bark;
}
#endif

#ifdef BARK_SPINED
#define BARK_OWN
// Above a half the tile's darkness stands for wool and spines.
float barkOwnTexel() {
  float spine = smoothstep(0.45, 0.75, barkTexel.x);
  barkTexel.x = 2.0 * barkTexel.x * (1.0 - spine);
  return spine;
}

vec3 barkOwn(vec3 bark, float spine) {
  return mix(bark, vec3(0.60, 0.52, 0.34), spine);
}
#endif

#ifdef BARK_BLOOM
#define BARK_OWN
float barkOwnTexel() {
  return 0.4 * smoothstep(0.32, 0.04, barkTexel.x);
}

// Where the tile is lightest a cane is dusted with wax.
vec3 barkOwn(vec3 bark, float wax) {
  return mix(bark, vec3(0.6, 0.64, 0.55), wax);
}
#endif
