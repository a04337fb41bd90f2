#include /debug/check.glsl
#include /lib/quaternion.glsl
#include /wind/bend.glsl
#include /wind/spring.glsl
// Inputs: two states of three texels, the frame at rest, beta x, y | 0 | lever, acceleration of the base | reach, the transition.
void main() {
  vec4 given7 = given(7);
  vec4 given8 = given(8);
  Spring first = Spring(given(0), given(1), given(2));
  mat3 frame = matrixFromQuaternion(given(6));
  vec3 target = springTarget(frame, given7.xyz, given8.xyz, given7.w);
  Spring next = springStep(first.q, target, given(9), frame, given8.xyz, given8.w, first.base.w);
  Spring begun = springStart(target, first.base.w);
  Spring mixed = mixSpring(first, Spring(given(3), given(4), given(5)), given8.w);
  out0 = next.q;
  out1 = next.end;
  out2 = vec4(begun.q.xy, begun.base.w, begun.end.w);
  out3 = vec4(framePush(frame, springBend(mixed), vec2(0.14, 0.6)).third, springStir(mixed, 0.3));
}
