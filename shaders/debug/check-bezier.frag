#include /debug/check.glsl
#include /lib/bezier.glsl
// Inputs: P0 | u, P1 | length at rest, P2, P3.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  Cubic curve = Cubic(a.xyz, b.xyz, given(2).xyz, given(3).xyz);
  out0 = vec4(bezierPoint(curve, a.w), arcLength(curve));
  out1 = vec4(bezierDerivative(curve, a.w), 0.0);
  out2 = vec4(bezierSecondDerivative(curve, a.w), 0.0);
  out3 = vec4(holdArc(curve, b.w).p3, 0.0);
}
