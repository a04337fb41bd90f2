// The wind's handle on the ground around the tree: two rings, ticks, an arrow from the knob to the inner ring. Tree space.
// position: what it says by kind | kind. corner: offset from there, in pixels or as -1..1.
// kind 0: ring; x angle in turns, y 0 inner or 1 outer. 1: tick; x angle, y 0..1 along it. 2: shaft; y 0 knob, 1 neck.
// 3: head; y 0 neck, 1 tip. 4: knob.
#include /overlay/screen.glsl

in vec2 corner;

// Radius of the inner and the outer ring, height above the ground, scale of the pixels.
uniform vec4 handleShape;
// Direction towards which the wind blows x, y (unit) | strength 0..1 | glow 0..1
uniform vec4 handleWind;

// Place within the mark, -1..1 where it is a disc, across -1..1 where it is a line | kind | half its size in pixels.
out vec4 vMark;

const float TAU = 6.283185307;

void main() {
  int kind = int(position.z + 0.5);
  float pixel = handleShape.w;
  float radius = mix(handleShape.x, handleShape.y, kind == 0 ? position.y : 1.0);
  vec2 round = vec2(cos(position.x * TAU), sin(position.x * TAU));
  vec2 wind = handleWind.xy;
  float knob = mix(handleShape.x, handleShape.y, handleWind.z);
  vec3 p;
  vec3 q;
  float half_;
  if (kind == 0) {
    p = vec3(round * radius, 0.0);
    q = p + vec3(-round.y, round.x, 0.0) * (0.05 * radius);
    half_ = position.y > 0.5 ? 0.9 : 0.9;
  } else if (kind == 1) {
    float size = fract(position.x * 4.0 + 0.01) < 0.1 ? 0.075 : 0.035;
    p = vec3(round * radius * (1.0 + size * position.y), 0.0);
    q = p + vec3(round, 0.0) * (0.05 * radius);
    half_ = 0.9;
  } else {
    float tip = handleShape.x * 0.82;
    p = vec3(-wind * (kind == 4 ? knob : mix(knob, tip, kind == 2 ? 0.0 : 1.0)), 0.0);
    q = vec3(-wind * (kind == 4 ? 0.0 : tip * 0.5), 0.0);
    half_ = kind == 2 ? 1.9 : kind == 3 ? 7.0 : 22.0;
  }
  p.z = q.z = handleShape.z;
  half_ *= pixel;
  vec4 a = onScreen(p);
  vec4 b = onScreen(q);
  vec2 way = screenWay(a, b);
  vec2 side = vec2(-way.y, way.x);
  if (kind == 2) {
    // From the knob to the neck of the head, on screen.
    vec4 tip = onScreen(vec3(-wind * (handleShape.x * 0.82), handleShape.z));
    a = position.y > 0.5 ? movedBy(tip, -way * 12.0 * pixel) : a;
    gl_Position = movedBy(a, side * corner.x * (half_ + 1.0));
  } else if (kind == 3) {
    gl_Position = movedBy(a, side * corner.x * (half_ + 1.0) - way * ((1.0 - position.y) * 15.0 * pixel - 1.0));
  } else if (kind == 4) {
    gl_Position = movedBy(a, corner * half_);
  } else {
    gl_Position = movedBy(a, side * corner.x * (half_ + 1.0));
  }
  vMark = vec4(corner, float(kind) + (kind == 0 ? 0.5 * position.y : 0.0), half_);
}
