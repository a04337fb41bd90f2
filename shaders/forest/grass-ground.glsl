// Grass on a terrain: it goes before the meadow's own shader (shaders/stage/grass.glsl), in place of its plain.
#define GRASS_ON_TERRAIN
#include /forest/terrain-height.glsl
uniform sampler2D terrainShade;
out vec2 vTerrain;

// Height of the ground at a root (x, z); grown: how high a blade grows there; own: the blade's own number, 0..1.
float grassGround(vec2 root, float own, inout float grown) {
  vTerrain = vec2(root.x, -root.y);
  // Under dense crowns litter lies in its place.
  float open = textureLod(terrainShade, vTerrain * terrainPlace.x + 0.5, 1.0).g;
  grown *= smoothstep(0.25, 0.8, open + 0.3 * (own - 0.5));
  return terrainAt(vTerrain);
}
