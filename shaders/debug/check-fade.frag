#include /debug/check.glsl
#include /forest/fade.glsl
#include /forest/dither.glsl
#include /lib/trig.glsl
// Inputs: foot, height | eye, scale | band of the class, of the nearer one | height in pixels, what has come, what is taken, pixel's x |
// its y.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec4 fade = given(2);
  vec4 c = given(3);
  float noise = ditherAt(vec2(c.w, given(4).x));
  out0 = vec4(treePixels(a.xyz, a.w, b.xyz, b.w), treeShare(fade.xy, c.x), treeShares(fade, c.x, c.yz));
  // As an angle: nothing is as near to one as zero is.
  out1 = vec4(cosTurns(noise), sinTurns(noise), 0.0, 0.0);
  out2 = vec4(0.0);
  out3 = vec4(0.0);
}
