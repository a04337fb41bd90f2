#include /debug/check.glsl
#include /lib/quaternion.glsl
void main() {
  vec4 q = given(0);
  mat3 m = matrixFromQuaternion(q);
  out0 = vec4(rotateByQuaternion(q, given(1).xyz), 0.0);
  out1 = vec4(m[0], 0.0);
  out2 = vec4(m[1], 0.0);
  out3 = vec4(m[2], 0.0);
}
