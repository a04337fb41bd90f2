#include /debug/check.glsl
#include /branch/radius.glsl
// Inputs: z | angle in turns | radius | length, then taper | flare | bulges | their depth, then lobes | depth | fade | Skjermo's t.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 c = given(2);
  Shape shape = Shape(b.x, b.y, c.x, c.y, c.z, b.z, b.w);
  out0 = vec4(taperRadius(a.x, b.x, a.z, a.w), powerTaper(a.x, a.z, c.w));
  out1 = vec4(flare(a.x, b.y), clampedFlare(a.x, b.y));
  out2 = vec4(bulges(a.x, b.z, b.w), 0.0, 0.0);
  out2.zw = lobes(a.x, a.y, c.x, c.y, c.z).xy;
  out3 = vec4(lobes(a.x, a.y, c.x, c.y, c.z).z, stemRadius(shape, a.z, a.w, a.x, a.y));
}
