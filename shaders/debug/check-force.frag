#include /debug/check.glsl
#include /wind/force.glsl
// Inputs: x | y | z of a place in tree space. The wind is uniforms, the same for all samples of a draw.
void main() {
  vec3 place = given(0).xyz;
  out0 = vec4(windForce(place), linearWindForce(place.xy));
  out1 = vec4(wavesForce(place.xy), wavePush(windWaves[0], windPhases[0], place.xy));
  out2 = vec4(0.0);
  out3 = vec4(0.0);
}
