#ifndef WIND_POSE
#define WIND_POSE
#include /lib/quaternion.glsl
#include /lib/bezier.glsl
#include /lib/frames.glsl
#include /wind/bend.glsl
// pose: the control points of a piece from its parent's, its rest shape and its bend. Metres, tree space.
// Twin: src/core/wind/pose.ts

// What a piece is at rest; control points in the base frame. third: of the stem's length; weights: bend of P2 and P3.
struct RestPiece {
  float v;
  vec4 orientation;
  float p1x;
  vec3 p2;
  vec3 p3;
  float arc;
  vec2 weights;
  float third;
};

// Where a piece is: its curve, its orientation vector, and how hard its leaves are shaken, metres of force.
struct Pose {
  Cubic curve;
  vec3 o;
  float stir;
};

// Control points and orientation vector of a piece whose base frame is `frame` and whose P0 is `at`.
Pose placePiece(vec3 at, mat3 frame, RestPiece rest) {
  return Pose(
    Cubic(at, at + frame[0] * rest.p1x, at + frame * rest.p2, at + frame * rest.p3),
    frame[1],
    0.0
  );
}

// The handles of a parent, in the printed form for teaching.
Handles parentHandles(Cubic parent, vec3 o) {
  if (windPaper) return projectedHandlesOf(parent, o);
  return handlesOf(parent, o);
}

// A piece at its parent's attachment, unbent: P_i = C(v) + [U T^ S^](v) q p_i, O = the second column
// (Skjermo 2007, 4.2, errata E33 and E34).
Pose attachPiece(Cubic parent, vec3 parentO, RestPiece rest) {
  mat3 section = sectionFrame(parent, parentHandles(parent, parentO), rest.v);
  return placePiece(bezierPoint(parent, rest.v), section * matrixFromQuaternion(rest.orientation), rest);
}

// A root, which stands where it stood: `at` is its P0, and its orientation is in tree space.
Pose attachRoot(vec3 at, RestPiece rest) {
  return placePiece(at, matrixFromQuaternion(rest.orientation), rest);
}

// A placed piece bent by a push, its leaves shaken by `stir`.
Pose bendPose(Pose placed, RestPiece rest, Push push, float stir) {
  return Pose(bendPiece(placed.curve, push, rest.arc), placed.o, stir);
}

// A child's pose from its parent's: attached, then bent (Skjermo 2007, 4.2 and equation 17).
Pose poseFromParent(Cubic parent, vec3 parentO, RestPiece rest, Push push, float stir) {
  return bendPose(attachPiece(parent, parentO, rest), rest, push, stir);
}
#endif
