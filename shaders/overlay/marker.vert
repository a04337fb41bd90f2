// The probe: a ring around the end of a piece, in the pose of the moment. Tree space.
// position.xy: corner of a square, -1..1.
#include /branch/read-pose.glsl
#include /overlay/screen.glsl

// Piece | 1 where its depth is odd.
uniform ivec2 markerPiece;

out vec2 vMark;

const float HALF = 14.0;

void main() {
  Pose pose = readPose(markerPiece.x, markerPiece.y == 1);
  vMark = position.xy * HALF;
  gl_Position = movedBy(onScreen(pose.curve.p3), vMark);
}
