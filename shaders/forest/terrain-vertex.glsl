// A patch of the ground: position.xy on the patch, 0..1; position.z is 1 on the skirt that hides the seams between patches.
#include /stage/field.glsl
#include /stage/sky.glsl
#include /forest/laid.glsl
#include /forest/terrain-height.glsl
#include /forest/terrain-slow.glsl

// Low corner of the patch and its side, forest space, metres.
in vec3 patchPlace;

uniform vec4 groundReach;
// Mean force of the wind, metres.
uniform float terrainMean;
#ifdef TERRAIN_WITHIN
uniform sampler2D grassMap;
#endif

out vec3 vGround;
out vec3 vHaze;
out vec2 vTerrain;
out float vLaid;
out vec2 vSlow;

vec3 terrainPoint() {
  vec2 xy = patchPlace.xy + position.xy * patchPlace.z;
  return vec3(xy, terrainAt(xy) - 0.06 * patchPlace.z * position.z);
}

// See vSlow in terrain-look.glsl.
vec2 terrainSlow(vec2 xy, float away) {
  float fade = terrainHaze(away, groundReach.xy);
#ifdef TERRAIN_WITHIN
  // Without what is finer than the widest cells of a patch.
  return vec2(fade, textureLod(grassMap, terrainWide(xy), 2.0).b);
#else
  return vec2(fade, 0.0);
#endif
}
