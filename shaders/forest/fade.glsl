#ifndef FOREST_FADE
#define FOREST_FADE
// Which part of a tree its class draws: near (all of it), middle (cards) or far (an impostor). Classes share a tree out by a pattern of
// noise, so that together they draw all of it and none of it twice (shaders/forest/dither.glsl). Metres; the space of the trees' places.

// The camera that the picture is for; in a shadow pass too, so that shadows fade as trees do.
uniform vec3 forestEye;
// Pixels of a metre at a metre from the eye.
uniform float forestScale;
// Heights in pixels between which the class comes in (x to y), and between which one that is nearer takes over (z to w).
uniform vec4 forestFade;

// How high a tree is on screen, in pixels. Twin: src/core/forest/fade.ts
float treePixels(vec3 foot, float height, vec3 eye, float scale) {
  return height * scale / max(distance(eye, foot + vec3(0.0, 0.0, 0.5 * height)), 0.01);
}

// Part of a tree, 0..1, that is drawn by a class whose band (from, to) it is, and those nearer. Twin: src/core/forest/fade.ts
float treeShare(vec2 fade, float pixels) {
  float x = clamp((pixels - fade.x) / max(fade.y - fade.x, 1e-3), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// The part that is drawn here: from x to y of the noise; nothing where y is not above x. there: how much of the tree has come in this
// class (x) and in the one that is nearer (y), 0..1: what streams in fades in, and nothing goes before something else is there.
// Twin: src/core/forest/fade.ts
vec2 treeShares(vec4 fade, float pixels, vec2 there) {
  return vec2(treeShare(fade.zw, pixels) * there.y, treeShare(fade.xy, pixels) * there.x);
}
#endif
