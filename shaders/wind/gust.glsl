#ifndef WIND_GUST
#define WIND_GUST
// Gusts: fronts that cross the meadow, once or in trains. Metres, seconds, tree axes. Twin: src/core/wind/gust.ts (fillGusts fills the uniforms)

// 3 a gust: direction x, y (unit), peak in metres, 1/width (0: without end) | 1/speed, seconds since the front passed the tree's place,
// rise, fall in seconds | metres that the tree's place lies left of the axis, seconds after which it comes again (0: never), how often it
// came before this time, 0. Slots not in use have no peak, but a rise and a fall.
uniform vec4 windGusts[24];

// 0..1 of the peak, s seconds after the front: up within `rise`, down within `fall`, both without a corner.
float gustEnvelope(float s, float rise, float fall) {
  float x = clamp(min(s / rise, 1.0 + (rise - s) / fall), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// 0..1 of the peak, d metres off the axis of a front of 1/perWidth metres: a half at half the width.
float gustWidth(float d, float perWidth) {
  float x = 2.0 * d * perWidth;
  return exp2(-x * x);
}

// Seconds since the last front of a train of them, by those since one of which `before` came before it, every `repeat` seconds; before the
// first of them less than 0.
float sinceFront(float s, float repeat, float before) {
  return s - repeat * max(floor(s / max(repeat, 1e-3)), -before);
}

// How hard a gust pushes at xy along its direction, metres. train: metres left of its axis, seconds to the next, fronts before.
float gustPush(vec4 front, vec4 timing, vec3 train, vec2 xy) {
  float s = sinceFront(timing.y - dot(front.xy, xy) * timing.x, train.y, train.z);
  float d = train.x + front.x * xy.y - front.y * xy.x;
  return front.z * gustEnvelope(s, timing.z, timing.w) * gustWidth(d, front.w);
}

// Force of gust i at xy: metres, horizontal. Twin: src/core/wind/gust.ts (gustPush)
vec2 gustForce(int i, vec2 xy) {
  vec4 front = windGusts[3 * i];
  return front.xy * gustPush(front, windGusts[3 * i + 1], windGusts[3 * i + 2].xyz, xy);
}

// Force of all gusts at xy: metres, horizontal. Written out, as the waves are.
vec2 gustsForce(vec2 xy) {
  vec2 force = gustForce(0, xy) + gustForce(1, xy) + gustForce(2, xy) + gustForce(3, xy);
  return force + gustForce(4, xy) + gustForce(5, xy) + gustForce(6, xy) + gustForce(7, xy);
}
#endif
