#include /debug/check.glsl
#include /wind/pose.glsl
// Inputs: the parent's P0 | O.x, P1 | O.y, P2 | O.z, P3 | v, the orientation, p2 | p1x, p3 | arc, push on the second edge | a root, push on
// the third edge | stir.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  vec4 d = given(3);
  vec4 handle = given(5);
  vec4 end = given(6);
  vec4 second = given(7);
  vec4 third = given(8);
  RestPiece rest = RestPiece(d.w, given(4), handle.w, handle.xyz, end.xyz, end.w, vec2(1.0), 1.0);
  Push push = Push(second.xyz, third.xyz);
  Pose pose;
  if (second.w > 0.5) pose = bendPose(attachRoot(a.xyz, rest), rest, push, third.w);
  else pose = poseFromParent(Cubic(a.xyz, b.xyz, c.xyz, d.xyz), vec3(a.w, b.w, c.w), rest, push, third.w);
  out0 = vec4(pose.curve.p0, pose.o.x);
  out1 = vec4(pose.curve.p1, pose.o.y);
  out2 = vec4(pose.curve.p2, pose.o.z);
  out3 = vec4(pose.curve.p3, pose.stir);
}
