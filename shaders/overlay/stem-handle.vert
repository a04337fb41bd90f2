// The handles of a stem in the pose of the moment: a knob beyond its tip, one at its side, and one on an arc at its base.
// Tree space. position: corner x, y of a mark (-1..1), or place along the arc 0..1 and side | kind.
// kind 0: length, 1: curve, 2: down angle, 3: the arc. src/view/picture/stem-stance.ts finds the same places for hands.
#include /branch/section.glsl
#include /overlay/screen.glsl

// Piece | 1 where its depth is odd: the first of the stem, the one of the curve's knob, the last, and the one that it grows on (-1: none).
uniform ivec2 stemEnds[4];
// v of the curve's knob | v on the parent | 1 where there is a down angle to drag | 1 for a stem whose handles are drawn.
uniform vec4 stemPlaces;
// How each knob is: 0 at rest, 1 pointed at, 2 held.
uniform vec3 stemGrips;

// Along the knob's way and across it, pixels | kind | state of the grip
out vec4 vMark;

const float HALF = 26.0;
const float BEYOND = 20.0;
const float LEAST_FOR_CURVE = 100.0;

vec2 pixelsOf(vec4 clip) {
  return 0.5 * clip.xy / clip.w * overlayPixels;
}

void main() {
  int kind = int(position.z + 0.5);
  Pose first = readPose(stemEnds[0].x, stemEnds[0].y == 1);
  Section base = sectionAt(first, 0.0);
  Pose last = readPose(stemEnds[2].x, stemEnds[2].y == 1);
  vec4 from = onScreen(base.centre);
  vec4 tip = onScreen(last.curve.p3);
  vec2 stretch = pixelsOf(tip) - pixelsOf(from);
  float pixels = length(stretch);
  vec2 axis = pixels > 1.0 ? stretch / pixels : vec2(0.0, 1.0);
  vMark = vec4(position.xy * HALF, float(kind), stemGrips[min(kind, 2)]);
  vec4 at;
  vec2 way;
  bool drawn = true;
  if (kind == 0) {
    way = axis;
    at = movedBy(tip, axis * BEYOND);
  } else if (kind == 1) {
    Section middle = sectionAt(readPose(stemEnds[1].x, stemEnds[1].y == 1), stemPlaces.x);
    at = onScreen(middle.centre);
    way = screenWay(at, onScreen(middle.centre - middle.t * (0.3 * length(last.curve.p3 - base.centre))));
    drawn = pixels >= LEAST_FOR_CURVE;
  } else {
    vec3 parent = vec3(0.0, 0.0, 1.0);
    if (stemEnds[3].x >= 0) parent = sectionAt(readPose(stemEnds[3].x, stemEnds[3].y == 1), stemPlaces.y).along;
    float c = dot(base.along, parent);
    vec3 out_ = base.along - parent * c;
    float s = length(out_);
    out_ = s > 1e-3 ? out_ / s : -base.t;
    float angle = atan(s, c);
    float radius = clamp(0.3 * pixels, 34.0, 60.0) / pixelsPerMetre(from);
    float turned = kind == 2 ? angle : angle * position.x;
    at = onScreen(base.centre + radius * (cos(turned) * parent + sin(turned) * out_));
    way = screenWay(at, onScreen(base.centre + radius * (cos(turned + 0.1) * parent + sin(turned + 0.1) * out_)));
    drawn = stemPlaces.z > 0.5;
  }
  if (kind == 3) {
    vMark.xy = vec2(0.0, position.y * 3.5);
    gl_Position = movedBy(at, vec2(-way.y, way.x) * vMark.y);
  } else {
    gl_Position = movedBy(at, way * vMark.x + vec2(-way.y, way.x) * vMark.y);
  }
  if (!drawn || stemPlaces.w < 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
