// One step of the wind: the pose of one piece a texel. force -> bend -> pose (Skjermo 2007, sections 4 and 5).
// In front of this text stand the precision and the layout of the textures (src/gpu/tree-shader.ts).
#include /lib/texel.glsl
#include /wind/force.glsl
#include /wind/pose.glsl

uniform sampler2DArray pieces;
// The set that this draw does not write: parents are read from it, and where a root stands.
uniform sampler2D parentPose[4];
uniform int log2Width;

layout(location = 0) out vec4 poseP0;
layout(location = 1) out vec4 poseP1;
layout(location = 2) out vec4 poseP2;
layout(location = 3) out vec4 poseP3;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 attach = texelFetch(pieces, ivec3(texel, PIECE_ATTACH), 0);
  vec4 handle = texelFetch(pieces, ivec3(texel, PIECE_HANDLE), 0);
  vec4 end = texelFetch(pieces, ivec3(texel, PIECE_END), 0);
  vec4 tip = texelFetch(pieces, ivec3(texel, PIECE_TIP), 0);
  RestPiece rest = RestPiece(
    attach.y,
    texelFetch(pieces, ivec3(texel, PIECE_ORIENT), 0),
    handle.w,
    handle.xyz,
    end.xyz,
    end.w,
    attach.zw,
    tip.w
  );

  int parent = int(attach.x);
  ivec2 from = parent < 0 ? texel : texelOf(parent, log2Width);
  vec4 p0 = texelFetch(parentPose[0], from, 0);
  vec4 p1 = texelFetch(parentPose[1], from, 0);
  vec4 p2 = texelFetch(parentPose[2], from, 0);
  vec4 p3 = texelFetch(parentPose[3], from, 0);
  // attachRoot or attachPiece; their common end once, since software GL runs both sides of a branch.
  Cubic curve = Cubic(p0.xyz, p1.xyz, p2.xyz, p3.xyz);
  vec3 o = vec3(p0.w, p1.w, p2.w);
  mat3 section = sectionFrame(curve, parentHandles(curve, o), rest.v);
  vec3 at = bezierPoint(curve, rest.v);
  if (parent < 0) {
    section = mat3(1.0);
    at = p0.xyz;
  }
  Pose placed = placePiece(at, section * matrixFromQuaternion(rest.orientation), rest);
  Pose pose = bendPose(placed, rest, windForce(tip.xy));

  poseP0 = vec4(pose.curve.p0, pose.o.x);
  poseP1 = vec4(pose.curve.p1, pose.o.y);
  poseP2 = vec4(pose.curve.p2, pose.o.z);
  poseP3 = vec4(pose.curve.p3, pose.angle);
}
