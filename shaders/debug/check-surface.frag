#include /debug/check.glsl
#include /branch/surface.glsl
#include /lib/trig.glsl
// Inputs: P0 | u, P1 | O.x, P2 | O.y, P3 | O.z, then angle in turns | rho | rhoU | q. PAPER: sections of blended handles.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  vec4 d = given(3);
  vec4 e = given(4);
  Cubic curve = Cubic(a.xyz, b.xyz, c.xyz, d.xyz);
  Handles h = handlesOf(curve, vec3(b.w, c.w, d.w));
#ifdef PAPER
  SurfacePoint s = paperSurfacePoint(curve, h, a.w, cosTurns(e.x), sinTurns(e.x), e.y, e.z, e.w);
#else
  SurfacePoint s = surfacePoint(curve, h, a.w, cosTurns(e.x), sinTurns(e.x), e.y, e.z, e.w);
#endif
  out0 = vec4(s.position, 0.0);
  out1 = vec4(s.normal, 0.0);
  out2 = vec4(s.around, 0.0);
  out3 = vec4(s.along, 0.0);
}
