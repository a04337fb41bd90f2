#include /debug/check.glsl
#include /lib/hash.glsl
#include /lib/texel.glsl
// Unsigned integers go in and out as two halves of 16 bits, which floats hold exactly.
void main() {
  vec4 a = given(0);
  uint hash = hashPcg((uint(a.x) << 16u) | uint(a.y));
  out0 = vec4(float(hash >> 16u), float(hash & 65535u), hashUnit(hash), 0.0);
  out1 = vec4(vec2(texelOf(int(a.z), int(a.w))), 0.0, 0.0);
  out2 = vec4(0.0);
  out3 = vec4(0.0);
}
