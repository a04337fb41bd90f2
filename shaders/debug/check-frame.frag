#include /debug/check.glsl
#include /lib/frames.glsl
// Inputs: P0 | u, P1 | O.x, P2 | O.y, P3 | O.z; then p, q, a of transport in three more layers.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  vec4 d = given(3);
  Cubic curve = Cubic(a.xyz, b.xyz, c.xyz, d.xyz);
  mat3 frame = sectionFrame(curve, handlesOf(curve, vec3(b.w, c.w, d.w)), a.w);
  out0 = vec4(frame[0], 0.0);
  out1 = vec4(frame[1], 0.0);
  out2 = vec4(frame[2], 0.0);
  out3 = vec4(transport(given(4).xyz, given(5).xyz, given(6).xyz), 0.0);
}
