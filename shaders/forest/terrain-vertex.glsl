// A patch of the ground: position.xy on the patch, 0..1; position.z is 1 on the skirt that hides the seams between patches.
#include /stage/field.glsl
#include /stage/sky.glsl
#include /forest/terrain-height.glsl

// Low corner of the patch and its side, forest space, metres.
in vec3 patchPlace;

out vec3 vGround;
out vec3 vHaze;
out vec2 vTerrain;
out float vLaid;

vec3 terrainPoint() {
  vec2 xy = patchPlace.xy + position.xy * patchPlace.z;
  return vec3(xy, terrainAt(xy) - 0.06 * patchPlace.z * position.z);
}
