// Colour, normal and light of a far tree, from its pictures.
#include /forest/impostor-read.glsl
#include /forest/laid.glsl

in vec3 vCorner;
in float vLaid;
flat in vec3 vToEye;
// Turns tree space into view space.
flat in mat3 vTreeView;
// Half of the width and of the height of a view | height about the centre above which leaves are | light lost in the crown a metre.
flat in vec4 vHalf;
flat in vec4 vThrough;

uniform highp sampler2DArray farShapes;

// Tree space, about the centre of the picture.
vec3 farPoint;
// View space.
vec3 farNormal;
// Light of the sky that reaches it.
float farSky;
float farAlpha;
// What differs from leaf to leaf.
vec3 farLeaf;
// How much of that shows, 0..1: all of it where a leaf is about a pixel, little where a pixel holds many.
float farRough;

vec3 farNormalOf(vec4 shape, vec2 cell) {
  vec2 xy = 2.0 * shape.xy - 1.0;
  return viewFrame(viewDirection(cell, farViews.x)) * vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
}

// Part of what is seen there that is leaves.
float farLeaves() {
  return smoothstep(-0.02, 0.05, (farPoint.z - vHalf.z) / vHalf.y);
}

// How far leaves turn from the mean of those around them.
const float FAR_SPREAD = 1.5;

// One of the three views for each leaf's worth of the picture, as often as it weighs: they pass into each other without a blur, for the
// price of one.
vec3 farDiffuse() {
  farLeaf = farNoise();
  farRough = clamp(1.15 - 0.3 * vCellC.w, 0.25, 1.0);
  vec3 w = vWeights * vWeights;
  float pick = fract(farLeaf.y * 3.0 + farLeaf.z * 5.0) * (w.x + w.y + w.z);
  // A trunk that was put together from three would be in pieces.
  if (vCorner.z < vHalf.z) pick = 0.0;
  vec2 cell = vCellC.xy;
  vec2 uv = vViewC;
  vec2 aside = vAsideC.xy;
  if (pick < w.x) {
    cell = vCellsAB.xy;
    uv = vViewsAB.xy;
    aside = vAsideAB.xy;
  } else if (pick < w.x + w.y) {
    cell = vCellsAB.zw;
    uv = vViewsAB.zw;
    aside = vAsideAB.zw;
  }
  vec4 shape = textureLod(farShapes, farPlaceOn(uv, cell), vCellC.w);
  float out_ = vAsideC.z * (1.0 - 2.0 * shape.z);
  if (vCellC.w < 1.5) {
    // What the view shows lies this far in front of the quad: from where the eye is it is seen beside.
    uv += out_ * aside;
    shape = textureLod(farShapes, farPlaceOn(uv, cell), vCellC.w);
    out_ = vAsideC.z * (1.0 - 2.0 * shape.z);
  }
  vec4 colour = farColour(uv, cell);
  farPoint = vCorner + vToEye * out_;
  float leaves = farLeaves();
  farAlpha = colour.a + mix(0.15, (farLeaf.x - 0.5) * 0.5 * farRough, leaves);
  // What the cut takes of a tree is its rim, where most of the sky is seen.
  farSky = min(1.04 * shape.a, 1.0);
  vec3 own = vec3(farLeaf.yz, fract(farLeaf.y * 17.0 + farLeaf.z * 5.0)) - 0.5;
  vec3 n = farNormalOf(shape, cell) + own * (FAR_SPREAD * farRough * leaves);
  // Leaves show the eye the side that they turn to it.
  n -= vToEye * min(2.0 * dot(n, vToEye), 0.0);
  farNormal = normalize(vTreeView * n);
  return laidColour(colour.rgb, vLaid * leaves);
}
