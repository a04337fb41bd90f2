// One step of the springs: force and the parent's acceleration -> bend and its velocity, one piece a texel (src/core/wind/spring-tree.ts).
// With SPRING_SEED the state from which a run starts. In front of this text stand the precision and the layout (src/gpu/tree-shader.ts).
#include /lib/texel.glsl
#include /lib/quaternion.glsl
#include /wind/force.glsl
#include /wind/bend.glsl
#include /wind/spring.glsl

uniform sampler2DArray pieces;
uniform sampler2DArray springs;
// The state of the step before, in the set that this draw does not write.
uniform sampler2D springFirst[4];
// How much of its base's acceleration shakes a branch, 0 to 1.
uniform float springInertia;
uniform int log2Width;

layout(location = 0) out vec4 stateQ;
layout(location = 1) out vec4 stateBase;
layout(location = 2) out vec4 stateEnd;
// The bend in tree space, as the pose takes it, and |F|: it follows from the state, and spares the pose the turning, at every depth.
layout(location = 3) out vec4 stateLean;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 tip = texelFetch(pieces, ivec3(texel, PIECE_TIP), 0);
  mat3 frame = matrixFromQuaternion(texelFetch(springs, ivec3(texel, SPRING_FRAME), 0));
  vec2 wind = windForce(tip.xyz);
  float force = length(wind);
  vec3 beta = bendVector(wind, tip.w, windExponents.x, windExponents.y);
#ifdef SPRING_SEED
  Spring spring = springStart(springTarget(frame, beta, vec3(0.0), 0.0), force);
#else
  vec4 attach = texelFetch(pieces, ivec3(texel, PIECE_ATTACH), 0);
  vec4 load = texelFetch(springs, ivec3(texel, SPRING_LOAD), 0);
  int parent = int(attach.x);
  ivec2 from = texelOf(max(parent, 0), log2Width);
  // The ground stands still. Parents are a step behind, so that accelerations run up the tree and never around in it.
  vec3 parentBase = texelFetch(springFirst[STATE_BASE], from, 0).xyz;
  vec3 parentEnd = texelFetch(springFirst[STATE_END], from, 0).xyz;
  vec3 base = parent < 0 ? vec3(0.0) : mix(parentBase, parentEnd, attach.y);
  vec3 target = springTarget(frame, beta, base, springInertia * load.x);
  Spring spring = springStep(
    texelFetch(springFirst[STATE_Q], texel, 0),
    target,
    texelFetch(springs, ivec3(texel, SPRING_STEP), 0),
    frame,
    base,
    load.y,
    force
  );
#endif
  stateQ = spring.q;
  stateBase = spring.base;
  stateEnd = spring.end;
  stateLean = vec4(frame * springBend(spring), force);
}
