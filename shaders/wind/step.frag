// One step of the wind: the pose of one piece a texel. force -> bend -> pose (Skjermo 2007, sections 4 and 5).
// In front of this text stand the precision and the layout of the textures (src/gpu/tree-shader.ts). WIND_MODEL is the bend model, and
// WIND_FROM, where it is there, the one that fades out; what is not asked for is not in the program.
#ifndef WIND_FROM
#define WIND_FROM WIND_MODEL
#endif
#include /lib/texel.glsl
#include /wind/pose.glsl
#if WIND_MODEL == 0 || WIND_FROM == 0
#include /wind/force.glsl
#endif
#if WIND_MODEL == 1 || WIND_FROM == 1
#include /wind/spring.glsl
// Of the springs' states of two steps what the pose needs, STATE_Q and the lean (spring.frag), and how far it is from the first to the
// second; with SPRING_WHOLE the first alone.
uniform sampler2D springQ[2];
uniform sampler2D springLean[2];
uniform float springFraction;
#endif
#if WIND_MODEL == 2 || WIND_FROM == 2
#include /wind/sway.glsl
uniform sampler2DArray sways;
#endif

uniform sampler2DArray pieces;
// The set that this draw does not write: parents are read from it, and where a root stands.
uniform sampler2D parentPose[4];
uniform int log2Width;
// Weight of WIND_MODEL, 0 to 1; WIND_FROM has the rest.
uniform float windModelFade;

layout(location = 0) out vec4 poseP0;
layout(location = 1) out vec4 poseP1;
layout(location = 2) out vec4 poseP2;
layout(location = 3) out vec4 poseP3;

// What a model does to a piece, and how hard it shakes its leaves.
struct Stirred {
  Push push;
  float stir;
};

#if WIND_MODEL == 0 || WIND_FROM == 0
Stirred directStirred(RestPiece rest, vec3 tip) {
  vec2 force = windForce(tip);
  return Stirred(directPush(force, rest.third, rest.weights), length(force));
}
#endif

#if WIND_MODEL == 1 || WIND_FROM == 1
Stirred springStirred(RestPiece rest, ivec2 texel) {
  vec4 q = texelFetch(springQ[0], texel, 0);
  vec4 lean = texelFetch(springLean[0], texel, 0);
#ifndef SPRING_WHOLE
  q = mix(q, texelFetch(springQ[1], texel, 0), springFraction);
  lean = mix(lean, texelFetch(springLean[1], texel, 0), springFraction);
#endif
  Spring spring = Spring(q, vec4(vec3(0.0), lean.w), vec4(0.0));
  return Stirred(weightedPush(lean.xyz, rest.weights), springStir(spring, rest.third));
}
#endif

#if WIND_MODEL == 2 || WIND_FROM == 2
Stirred swayStirred(mat3 frame, ivec2 texel) {
  vec4 gain = texelFetch(sways, ivec3(texel, SWAY_GAIN), 0);
  vec2 swing = swaySwing(gain, texelFetch(sways, ivec3(texel, SWAY_OFFSET), 0), windSway, windClock);
  return Stirred(framePush(frame, vec3(0.0, swing), gain.xy), swayStir(swing, windSway));
}
#endif

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
  mat3 frame = section * matrixFromQuaternion(rest.orientation);
  Pose placed = placePiece(at, frame, rest);

#define STIRRED_0 directStirred(rest, tip.xyz)
#define STIRRED_1 springStirred(rest, texel)
#define STIRRED_2 swayStirred(frame, texel)
#if WIND_MODEL == 0
  Stirred stirred = STIRRED_0;
#elif WIND_MODEL == 1
  Stirred stirred = STIRRED_1;
#else
  Stirred stirred = STIRRED_2;
#endif
#if WIND_FROM != WIND_MODEL
#if WIND_FROM == 0
  Stirred before = STIRRED_0;
#elif WIND_FROM == 1
  Stirred before = STIRRED_1;
#else
  Stirred before = STIRRED_2;
#endif
  stirred = Stirred(
    mixPush(before.push, stirred.push, windModelFade),
    mix(before.stir, stirred.stir, windModelFade)
  );
#endif
  Pose pose = bendPose(placed, rest, stirred.push, stirred.stir);

  poseP0 = vec4(pose.curve.p0, pose.o.x);
  poseP1 = vec4(pose.curve.p1, pose.o.y);
  poseP2 = vec4(pose.curve.p2, pose.o.z);
  poseP3 = vec4(pose.curve.p3, pose.stir);
}
