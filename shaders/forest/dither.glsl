#ifndef FOREST_DITHER
#define FOREST_DITHER
// Which pixels of a tree that fades its classes draw.

// Interleaved gradient noise of a pixel, 0..1: even in every small neighbourhood. Source: Jimenez 2014.
// Twin: src/core/forest/fade.ts
float ditherAt(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

// Is the fragment another class's to draw? Twin: src/core/forest/fade.ts
bool fadedOut(float shareLow, float shareHigh) {
  float noise = ditherAt(gl_FragCoord.xy);
  return noise < shareLow || noise >= shareHigh;
}
#endif
