#ifndef LIB_HUE
#define LIB_HUE
// A colour of full saturation; hue in turns. Twin: src/core/io/channels.ts
vec3 hueColour(float hue) {
  vec3 h = fract(hue + vec3(0.0, 2.0, 1.0) / 3.0);
  return clamp(abs(6.0 * h - 3.0) - 1.0, 0.0, 1.0);
}
#endif
