#ifndef OVERLAY_SCREEN
#define OVERLAY_SCREEN
// Lines and marks whose width is counted in pixels: at the flat angle of a meadow a strip that lay on the ground would vanish.

// Size of the picture in CSS pixels.
uniform vec2 overlayPixels;

vec4 onScreen(vec3 p) {
  return projectionMatrix * modelViewMatrix * vec4(p, 1.0);
}

// Pixels that a metre takes at a point in clip space.
float pixelsPerMetre(vec4 clip) {
  return 0.5 * projectionMatrix[1][1] * overlayPixels.y / clip.w;
}

// Direction on screen from a to b, unit length, in pixels.
vec2 screenWay(vec4 a, vec4 b) {
  vec2 way = (b.xy * a.w - a.xy * b.w) * overlayPixels;
  return way * inversesqrt(max(dot(way, way), 1e-12));
}

// A point moved by pixels on screen; its depth stays.
vec4 movedBy(vec4 clip, vec2 pixels) {
  clip.xy += pixels * (2.0 * clip.w) / overlayPixels;
  return clip;
}
#endif
