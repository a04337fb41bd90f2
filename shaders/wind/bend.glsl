#ifndef WIND_BEND
#define WIND_BEND
#include /lib/trig.glsl
#include /lib/bezier.glsl
// bend: what the wind does to a piece. Metres, tree space. Twin: src/core/wind/bend.ts

// Which model bends the tree, 0 direct, 1 spring, 2 sway; where one fades into another, WIND_FROM is the old one. Defines, since
// software GL runs both sides of a branch.
#ifndef WIND_MODEL
#define WIND_MODEL 0
#endif

// Exponent p of the force and m of the length that divides it: 1 and 0.6 in our winds, 1.8 and 2 in the paper.
uniform vec2 windExponents;
// Factor on every bend: 1/stiffness of the wind document.
uniform float windSoftness;
// The printed forms, for teaching.
#ifdef WIND_PAPER
const bool windPaper = true;
#else
const bool windPaper = false;
#endif

// Largest change of direction: a turn of 89.99 degrees. Beyond it float32 might overflow, and nothing turns any more.
const float MOST_BEND = 1e4;

// What is added to the directions of the second and the third edge of a piece.
struct Push {
  vec3 second;
  vec3 third;
};

// The change of direction that a force (metres, horizontal) gives a stem: F |F|^(p-1) / l^m with l a third of the stem's
// length, at most MOST_BEND (Skjermo 2007, equations 14 and 16, errata E27 and E28).
vec3 bendVector(vec2 force, float third, float p, float m) {
  float gain = p == 1.0 ? 1.0 : min(power(length(force), p - 1.0), 1e6);
  float softness = m == 1.0 ? 1.0 / third : m == 0.0 ? 1.0 : exp2(-m * log2(third));
  vec2 beta = force * (gain * min(softness, 1e6));
  float most = max(max(abs(beta.x), abs(beta.y)), 1e-9);
  return vec3(beta * min(1.0, MOST_BEND / most), 0.0);
}

// A change of direction shared out by the weights of a piece, times the softness of the tree.
Push weightedPush(vec3 beta, vec2 weights) {
  vec2 w = weights * windSoftness;
  return Push(beta * w.x, beta * w.y);
}

// direct, the paper's bend: at once as far as the force pushes. weights: those of P2 and P3; third: a third of the stem's length.
Push directPush(vec2 force, float third, vec2 weights) {
  return weightedPush(bendVector(force, third, windExponents.x, windExponents.y), weights);
}

// A bend given along the columns L, T and S of a frame: that at rest for a spring, the placed one for sway.
Push framePush(mat3 frame, vec3 q, vec2 weights) {
  return weightedPush(frame * q, weights);
}

// From one model's push to another's: f is 0 for the first, 1 for the second.
Push mixPush(Push a, Push b, float f) {
  return Push(mix(a.second, b.second, f), mix(a.third, b.third, f));
}

// The edge e turned by adding `push` to its direction; its length is kept. The part of a push against the edge does nothing: nothing
// turns by a right angle or more, and no edge flips over when the wind meets its very end.
vec3 leanEdge(vec3 e, vec3 push) {
  float l = length(e);
  vec3 d = e + push * l - e * min(dot(e, push) / max(l, 1e-30), 0.0);
  return d * (l / max(length(d), 1e-30));
}

// Least cosine between neighbouring edges of a bent piece, 105 degrees: what a piece at rest folds at most, but for a few.
const float FOLD = -0.26;

// The cosine of the angle between two edges, 0 where one has no length.
float edgeCosine(vec3 a, vec3 b) {
  return dot(a, b) * inversesqrt(max(dot(a, a) * dot(b, b), 1e-36));
}

// The edge b, turned towards the edge a before it where it would fold back on it further than to the cosine `least`: a piece that folds
// turns its frames over within a hair's breadth, and its arc length has no quadrature. Within 2 degrees of the way back it also gets
// shorter: there no side is nearer than another.
vec3 unfoldEdge(vec3 a, vec3 b, float least) {
  float c = edgeCosine(a, b);
  float aa = max(dot(a, a), 1e-30);
  float ab = dot(a, b) / aa;
  bool folds = c < least;
  float along = folds ? least * sqrt(dot(b, b) / aa) : ab;
  float aside = folds ? sqrt((1.0 - least * least) / max(1.0 - c * c, 1e-3)) : 1.0;
  return a * along + (b - a * ab) * aside;
}

// Bends a placed piece: its second and third edge lean and keep their lengths, P0 and P1 stay, and no two edges fold by more than 105
// degrees or what they fold at rest (Skjermo 2007, equation 17, errata E29 and E30).
Cubic leanPiece(Cubic c, Push push) {
  vec3 e1 = c.p1 - c.p0;
  vec3 e2 = c.p2 - c.p1;
  vec3 e3 = c.p3 - c.p2;
  vec3 f2 = unfoldEdge(e1, leanEdge(e2, push.second), min(edgeCosine(e1, e2), FOLD));
  vec3 f3 = unfoldEdge(f2, leanEdge(e3, push.third), min(edgeCosine(e2, e3), FOLD));
  vec3 p2 = c.p1 + f2;
  return Cubic(c.p0, c.p1, p2, p2 + f3);
}

// The step as printed, made consistent by the length that the print divides away: the branch stretches with the wind; for
// teaching (Skjermo 2007, equation 17, erratum E29).
Cubic paperBendStep(Cubic c, Push push) {
  vec3 e2 = c.p2 - c.p1;
  vec3 e3 = c.p3 - c.p2;
  vec3 p2 = c.p1 + e2 + push.second * length(e2);
  return Cubic(c.p0, c.p1, p2, p2 + e3 + push.third * length(e3));
}

// Bends a placed piece and gives it its arc length at rest back, not in the paper's form (equations.md 3.4 and 5.5).
Cubic bendPiece(Cubic c, Push push, float arc) {
  if (windPaper) return paperBendStep(c, push);
  return holdArc(leanPiece(c, push), arc);
}
#endif
