#include /debug/check.glsl
#include /wind/bend.glsl
#include /wind/sway.glsl
// Inputs: the texels of gain and offset, the clock, the amplitudes.
void main() {
  vec4 gain = given(0);
  vec2 clock = given(2).xy;
  vec4 parts = given(3);
  vec2 swing = swaySwing(gain, given(1), parts, clock);
  Push mixed = mixPush(Push(vec3(0.0), vec3(swing, 0.0)), Push(vec3(1.0, 2.0, 3.0), vec3(3.0, 2.0, 1.0)), gain.x);
  out0 = vec4(swing, swayStir(swing, parts), fract(swayPhase(gain.z, clock)));
  out1 = vec4(mixed.second, 0.0);
  out2 = vec4(mixed.third, 0.0);
  out3 = vec4(0.0);
}
