#ifndef FOREST_IMPOSTOR_READ
#define FOREST_IMPOSTOR_READ
// Reads the pictures of a far tree.
#include /forest/octahedral.glsl
#include /lib/hash.glsl

in vec4 vViewsAB;
in vec2 vViewC;
in vec2 vQuad;
flat in vec4 vCellsAB;
flat in vec4 vCellC;
flat in vec3 vWeights;
flat in vec4 vAsideAB;
flat in vec4 vAsideC;

uniform highp sampler2DArray farColours;
uniform vec4 farViews;

// Where a place of a view lies on its layer; nothing of its neighbours is filtered in. z: the layer.
vec3 farPlaceOn(vec2 uv, vec2 cell) {
  float rim = 0.5 * exp2(ceil(vCellC.w)) / farViews.y;
  return vec3((cell + clamp(uv, rim, 1.0 - rim)) / farViews.x, vCellC.z);
}

// Three numbers 0..1 of a leaf's worth of the quad, or of a pixel's where that is more: no view is in it, so that nothing jumps when
// another is the nearest.
vec3 farNoise() {
  ivec2 leaf = ivec2((vQuad + 2.0) * (0.5 * farViews.y * exp2(-floor(vCellC.w + 0.5))));
  uint a = hashPcg(uint(leaf.x + 512 * leaf.y) + 262144u * uint(4096.0 * vAsideC.w));
  uint b = hashPcg(a);
  return vec3(hashUnit(a), hashUnit(b), hashUnit(hashPcg(b)));
}

// Colour and coverage of a view.
vec4 farColour(vec2 uv, vec2 cell) {
  return textureLod(farColours, farPlaceOn(uv, cell), vCellC.w);
}
#endif
