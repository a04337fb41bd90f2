// What the wind pass is measured beside: attaches each piece to its parent and writes it, no force, no bend, no length kept.
#include /lib/texel.glsl
#include /wind/pose.glsl

uniform sampler2DArray pieces;
uniform sampler2D parentPose[4];
uniform int log2Width;

layout(location = 0) out vec4 poseP0;
layout(location = 1) out vec4 poseP1;
layout(location = 2) out vec4 poseP2;
layout(location = 3) out vec4 poseP3;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 attach = texelFetch(pieces, ivec3(texel, PIECE_ATTACH), 0);
  vec4 orient = texelFetch(pieces, ivec3(texel, PIECE_ORIENT), 0);
  vec4 handle = texelFetch(pieces, ivec3(texel, PIECE_HANDLE), 0);
  vec4 end = texelFetch(pieces, ivec3(texel, PIECE_END), 0);
  RestPiece rest = RestPiece(attach.y, orient, handle.w, handle.xyz, end.xyz, end.w, attach.zw, 1.0);
  int parent = int(attach.x);
  ivec2 from = parent < 0 ? texel : texelOf(parent, log2Width);
  vec4 p0 = texelFetch(parentPose[0], from, 0);
  vec4 p1 = texelFetch(parentPose[1], from, 0);
  vec4 p2 = texelFetch(parentPose[2], from, 0);
  vec4 p3 = texelFetch(parentPose[3], from, 0);
  Pose pose;
  if (parent < 0) pose = attachRoot(p0.xyz, rest);
  else pose = attachPiece(Cubic(p0.xyz, p1.xyz, p2.xyz, p3.xyz), vec3(p0.w, p1.w, p2.w), rest);
  poseP0 = vec4(pose.curve.p0, pose.o.x);
  poseP1 = vec4(pose.curve.p1, pose.o.y);
  poseP2 = vec4(pose.curve.p2, pose.o.z);
  poseP3 = vec4(pose.curve.p3, 0.0);
}
