#ifndef FOREST_DITHER
#define FOREST_DITHER
// Is the fragment another class's to draw? Interleaved gradient noise (Jimenez 2014): even in every small neighbourhood.
bool fadedOut(float shareLow, float shareHigh) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return noise < shareLow || noise >= shareHigh;
}
#endif
