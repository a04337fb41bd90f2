#include /debug/check.glsl
#include /lib/trig.glsl
// Twin and inputs: src/gpu/crosscheck/functions/numbers.ts
void main() {
  vec4 a = given(0);
  out0 = vec4(sinTurns(a.x), cosTurns(a.x), power(a.y, a.z), angleOfChord(a.w));
  out1 = vec4(0.0);
  out2 = vec4(0.0);
  out3 = vec4(0.0);
}
