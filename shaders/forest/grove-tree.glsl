#ifndef FOREST_GROVE_TREE
#define FOREST_GROVE_TREE
#include /lib/texel.glsl
#include /forest/fade.glsl
// The tree of a grove that a vertex belongs to, and how much of it is drawn. Grove space: metres, z up.

// Layers of TREE_LAYERS.
uniform highp sampler2DArray trees;
uniform int treeLog2Width;

// Range of the noise in which the tree is drawn.
flat out vec2 vShare;

// Its texel.
ivec2 groveTree = ivec2(0);

vec4 treeTexel(int layer) {
  return texelFetch(trees, ivec3(groveTree, layer), 0);
}

// Makes tree `index` the one that this vertex belongs to; false where nothing of it is drawn.
bool enterTree(int index) {
  groveTree = texelOf(index, treeLog2Width);
  vec4 place = treeTexel(TREE_PLACE);
  vShare = treeShares(forestFade, treePixels(place.xyz, place.w, forestEye, forestScale), treeTexel(TREE_TURN).zw);
  return vShare.x < vShare.y;
}

// A direction of grove space along the tree's own axes.
vec3 toTree(vec3 d) {
  vec2 turn = treeTexel(TREE_TURN).xy;
  return vec3(turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x, d.z);
}

// A direction along the tree's own axes in grove space.
vec3 fromTree(vec3 d) {
  vec2 turn = treeTexel(TREE_TURN).xy;
  return vec3(turn.x * d.x - turn.y * d.y, turn.x * d.y + turn.y * d.x, d.z);
}

// A point about the centre of the tree's crown, in its radii along the tree's own axes.
vec3 inCrown(vec3 p) {
  return toTree(p - treeTexel(TREE_CROWN).xyz) / treeTexel(TREE_RADII).xyz;
}
#endif
