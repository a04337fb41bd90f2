#ifndef FOREST_TERRAIN_SLOW
#define FOREST_TERRAIN_SLOW
// What changes so slowly over the ground of a forest that its vertices may bring it.

// Density of the haze, 1 / metre; part of the direct light that the ground's shade may take.
uniform vec2 terrainAir;

// Where the widest patches of a place lie in grassMap.
vec2 terrainWide(vec2 xy) {
  return mat2(0.83, -0.56, 0.56, 0.83) * xy * 0.0031 + 0.23;
}

// How much the haze takes, 0..1. away: metres from the eye; reach: where the ground begins and ends to fade, metres.
float terrainHaze(float away, vec2 reach) {
  float depth = away * terrainAir.x;
  // Some of the land shows to where it ends: what is before the skyline must not be paler than that is.
  return max(0.8 * (1.0 - exp(-depth * depth)), smoothstep(reach.x, reach.y, away));
}
#endif
