#include /debug/check.glsl
#include /lib/frames.glsl
// Inputs: P0 | u, P1 | O.x, P2 | O.y, P3 | O.z. PROJECTED: the handles as equation 8 prints them.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  vec4 d = given(3);
  Cubic curve = Cubic(a.xyz, b.xyz, c.xyz, d.xyz);
  vec3 o = vec3(b.w, c.w, d.w);
#ifdef PROJECTED
  Handles h = projectedHandlesOf(curve, o);
#else
  Handles h = handlesOf(curve, o);
#endif
  out0 = vec4(h.l0, h.l1.x);
  out1 = vec4(h.t0, h.l1.y);
  out2 = vec4(h.t1, h.l1.z);
  out3 = vec4(h.t2, h.l2.x);
}
