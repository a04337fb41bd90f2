#include /debug/check.glsl
#include /forest/octahedral.glsl
// Inputs: direction, views a side | place on the square, cell. Which three views are nearest jumps; what they weigh, and any mean over
// them, does not: that is compared.
void main() {
  vec4 a = given(0);
  vec4 b = given(1);
  mat3 near = nearestViews(a.xyz, a.w);
  float mean = 0.0;
  for (int i = 0; i < 3; i++) {
    vec2 cell = near[i].xy / (a.w - 1.0);
    mean += near[i].z * (cell.x * cell.x + 3.0 * cell.y * cell.y + 2.0 * cell.x * cell.y);
  }
  out0 = vec4(hemiOctahedral(a.xyz), near[0].z, mean);
  out1 = vec4(fromHemiOctahedral(b.xy), near[1].z + near[2].z);
  mat3 frame = viewFrame(a.xyz);
  out2 = vec4(frame[0], frame[1].x);
  out3 = vec4(frame[1].yz, viewDirection(b.zw, a.w).xy);
}
