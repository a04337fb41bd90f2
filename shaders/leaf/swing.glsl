#ifndef LEAF_SWING
#define LEAF_SWING
#include /lib/trig.glsl
// How the wind turns a leaf about the foot of its stalk, where it stays. Twin: src/core/deform/leaf-swing.ts

// Sines of the angles about the stalk and across it, each within a right angle; how far the blade leans downwind (tangent).
struct LeafSwing {
  vec2 sines;
  float lean;
};

// stir: how hard it is shaken, metres of force. own, phase: the leaf's own numbers, 0..1. pliant: widest angle of its flutter in
// radians, which says how soft its stalk is. beats: time in sixteenths of a beat, 0..1: each leaf beats a whole number of times in
// sixteen, so that time may wrap without a jump and no two neighbours stay in step.
LeafSwing leafSwing(float stir, float own, float phase, float pliant, float beats) {
  float beat = floor(11.0 + 11.0 * own);
  float hard = 1.0 - exp2(-12.0 * stir);
  float x = clamp((stir - 0.1) * 2.0, 0.0, 1.0);
  float stream = x * x * (3.0 - 2.0 * x);
  // A leaf rests now and then while its neighbours tremble.
  float rest = 0.65 + 0.35 * sinTurns(floor(2.0 + 3.0 * phase) * beats + 3.0 * own);
  float shake = sinTurns(beat * beats + phase) + 0.5 * sinTurns((beat + 6.0) * beats + 2.0 * phase);
  float nod = sinTurns((beat - 4.0) * beats + 3.0 * phase) - 0.4;
  // In strong wind a leaf streams: it beats faster and less widely, and no longer turns over.
  float wide = pliant * hard * rest * (1.0 - 0.6 * stream);
  float fast = pliant * stream;
  float roll = 0.75 * wide * shake + 0.3 * fast * sinTurns((2.0 * beat + 5.0) * beats + 5.0 * phase);
  float pitch = 0.4 * wide * nod + 0.2 * fast * sinTurns((2.0 * beat + 9.0) * beats + 7.0 * phase);
  float lean = pliant * 4.5 * (1.0 - exp2(-2.4 * stir)) * (0.7 + 0.6 * own) * (1.0 + 0.12 * shake);
  return LeafSwing(clamp(vec2(roll, pitch), -0.95, 0.95), lean);
}

// Where the unit vector d comes to that leans by `lean` (tangent of the widest angle) along `way`, horizontal, at most 1 long: by
// what of it lies across d, so that a leaf that points into the wind does not turn over.
vec3 leanTowards(vec3 d, vec2 way, float lean) {
  vec3 w = vec3(way, 0.0);
  vec3 e = d + lean * (w - d * dot(w, d));
  return e * inversesqrt(dot(e, e));
}

// a carried along by the shortest turn of the unit vector d to the unit vector e, less than a right angle away.
vec3 turnAlong(vec3 a, vec3 d, vec3 e) {
  vec3 k = cross(d, e);
  vec3 b = cross(k, a);
  return a + b + cross(k, b) / (1.0 + dot(d, e));
}
#endif
