#include /debug/check.glsl
#include /wind/force.glsl
// Inputs: x | y of a place in tree space. The waves are uniforms, the same for all samples of a draw.
void main() {
  vec2 xy = given(0).xy;
  out0 = vec4(windForce(xy), linearWindForce(xy));
  out1 = vec4(0.0);
  out2 = vec4(0.0);
  out3 = vec4(0.0);
}
