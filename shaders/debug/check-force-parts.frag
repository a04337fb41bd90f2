#include /debug/check.glsl
#include /wind/force.glsl
// Inputs: x | y of a place | z in heights | seconds after a front / rise | fall | metres off an axis | 1/width | 0. Gusts, record and
// profile are uniforms, the same for all samples of a draw.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  out0 = vec4(gustsForce(a.xy), recordForce(a.xy));
  out1 = vec4(profileFactor(a.z), gustEnvelope(a.w, b.x, b.y), gustWidth(b.z, b.w), 0.0);
  out2 = vec4(gustForce(0, a.xy), gustPush(windGusts[0], windGusts[1], windGusts[2].xyz, a.xy), 0.0);
  out3 = vec4(0.0);
}
