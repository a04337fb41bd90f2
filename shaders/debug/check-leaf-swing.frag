#include /debug/check.glsl
#include /leaf/swing.glsl
// Inputs: stir, own, phase, pliant | direction of the leaf, beats | direction of the wind, - | a vector.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  vec2 way = given(2).xy;
  LeafSwing swing = leafSwing(a.x, a.y, a.z, a.w, b.w);
  vec3 leant = leanTowards(b.xyz, way, swing.lean);
  out0 = vec4(swing.sines, swing.lean, 0.0);
  out1 = vec4(leant, 0.0);
  out2 = vec4(turnAlong(given(3).xyz, b.xyz, leant), 0.0);
  out3 = vec4(0.0);
}
