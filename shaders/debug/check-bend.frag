#include /debug/check.glsl
#include /wind/bend.glsl
// Inputs: P0 | force x, P1 | force y, P2 | third, P3 | arc length, then weights of P2 and P3 | p | m of bendVector.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  vec4 d = given(3);
  vec4 e = given(4);
  Cubic curve = Cubic(a.xyz, b.xyz, c.xyz, d.xyz);
  vec2 force = vec2(a.w, b.w);
  Cubic bent = bendPiece(curve, directPush(force, c.w, e.xy), d.w);
  out0 = vec4(bent.p1, 0.0);
  out1 = vec4(bent.p2, 0.0);
  out2 = vec4(bent.p3, 0.0);
  out3 = vec4(bendVector(force, c.w, e.z, e.w), 0.0);
}
