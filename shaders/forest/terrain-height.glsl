#ifndef FOREST_TERRAIN_HEIGHT
#define FOREST_TERRAIN_HEIGHT
// Heights of the ground, metres, one texel a corner of the grid; row 0 is the south edge.
uniform highp sampler2D terrainHeights;
// 1 / side of the square in metres, cells a side, height of the land far outside, metres.
uniform vec3 terrainPlace;

// How far outside of the square, in sides of it; 0 within. Forest space, metres.
float terrainOutside(vec2 xy) {
  vec2 away = abs(xy) * terrainPlace.x - 0.5;
  return length(max(away, 0.0));
}

// Height at a place: straight between the corners of the grid, as the mesh is; beyond the square the land evens out.
float terrainAt(vec2 xy) {
  vec2 at = clamp(xy * terrainPlace.x + 0.5, 0.0, 1.0) * terrainPlace.y;
  ivec2 low = ivec2(min(floor(at), terrainPlace.y - 1.0));
  vec2 part = at - vec2(low);
  float a = texelFetch(terrainHeights, low, 0).r;
  float b = texelFetch(terrainHeights, low + ivec2(1, 0), 0).r;
  float c = texelFetch(terrainHeights, low + ivec2(0, 1), 0).r;
  float d = texelFetch(terrainHeights, low + ivec2(1, 1), 0).r;
  float inside = mix(mix(a, b, part.x), mix(c, d, part.x), part.y);
  return mix(inside, terrainPlace.z, smoothstep(0.0, 1.3, terrainOutside(xy)));
}
#endif
