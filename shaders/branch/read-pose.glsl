#ifndef BRANCH_READ_POSE
#define BRANCH_READ_POSE
#include /lib/bezier.glsl
#include /lib/texel.glsl
// Where a piece stands this frame, as the wind pass left it (POSE_TARGETS in src/core/pack/layout.ts).

uniform highp sampler2D poseEven[4];
uniform highp sampler2D poseOdd[4];
uniform int poseLog2Width;

// Control points in tree space, the orientation vector across the first edge, and how hard leaves are shaken there, metres of force.
struct Pose {
  Cubic curve;
  vec3 across;
  float stir;
};

// Pieces of even depth live in one set of textures and those of odd depth in the other (equations.md 4.1).
Pose readPose(int piece, bool odd) {
  ivec2 texel = texelOf(piece, poseLog2Width);
  vec4 a;
  vec4 b;
  vec4 c;
  vec4 d;
  if (odd) {
    a = texelFetch(poseOdd[0], texel, 0);
    b = texelFetch(poseOdd[1], texel, 0);
    c = texelFetch(poseOdd[2], texel, 0);
    d = texelFetch(poseOdd[3], texel, 0);
  } else {
    a = texelFetch(poseEven[0], texel, 0);
    b = texelFetch(poseEven[1], texel, 0);
    c = texelFetch(poseEven[2], texel, 0);
    d = texelFetch(poseEven[3], texel, 0);
  }
  return Pose(Cubic(a.xyz, b.xyz, c.xyz, d.xyz), vec3(a.w, b.w, c.w), d.w);
}
#endif
