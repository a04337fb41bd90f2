#ifndef WIND_BEND
#define WIND_BEND
#include /lib/trig.glsl
#include /lib/bezier.glsl
// bend: what a force does to a piece. Metres, tree space. Twin: src/core/wind/bend.ts

// Exponent p of the force and m of the length that divides it: 1 and 0.6 in the presets, 1.8 and 2 in the paper.
uniform vec2 windExponents;
// The printed forms, for teaching: a define, since software GL runs both sides of a branch and most trees ask for one.
#ifdef WIND_PAPER
const bool windPaper = true;
#else
const bool windPaper = false;
#endif

// A bent curve and the angle in radians by which its last edge turned.
struct Bent {
  Cubic curve;
  float angle;
};

// The change of direction that a force (metres, horizontal) gives a stem: F |F|^(p-1) / l^m with l a third of the stem's
// length (Skjermo 2007, equations 14 and 16, errata E27 and E28).
vec3 bendVector(vec2 force, float third, float p, float m) {
  float gain = p == 1.0 ? 1.0 : power(length(force), p - 1.0);
  float softness = m == 1.0 ? 1.0 / third : m == 0.0 ? 1.0 : exp2(-m * log2(third));
  return vec3(force * (gain * softness), 0.0);
}

// The edge e turned by adding `push` to its direction; its length is kept. Against the edge itself nothing can turn it.
vec3 turnEdge(vec3 e, vec3 push) {
  float l = length(e);
  vec3 d = e + push * l;
  float n = length(d);
  return n > 1e-6 * l ? d * (l / n) : e;
}

// The angle in radians between two edges, 0 where one has no length.
float turnAngle(vec3 a, vec3 b) {
  float m = length(a);
  float n = length(b);
  return m > 0.0 && n > 0.0 ? angleOfChord(distance(a / m, b / n)) : 0.0;
}

// Bends a placed piece: its second and third edge turn by w.x and w.y times beta and keep their lengths, P0 and P1 stay
// (Skjermo 2007, equation 17, errata E29 and E30).
Bent bendStep(Cubic c, vec3 beta, vec2 w) {
  vec3 e3 = c.p3 - c.p2;
  vec3 f3 = turnEdge(e3, beta * w.y);
  vec3 p2 = c.p1 + turnEdge(c.p2 - c.p1, beta * w.x);
  float l3 = length(e3); // and that of f3
  return Bent(Cubic(c.p0, c.p1, p2, p2 + f3), l3 > 0.0 ? angleOfChord(distance(e3, f3) / l3) : 0.0);
}

// The step as printed, made consistent by the length that the print divides away: the branch stretches with the wind; for
// teaching (Skjermo 2007, equation 17, erratum E29).
Bent paperBendStep(Cubic c, vec3 beta, vec2 w) {
  vec3 e2 = c.p2 - c.p1;
  vec3 e3 = c.p3 - c.p2;
  vec3 f3 = e3 + beta * (w.y * length(e3));
  vec3 p2 = c.p1 + e2 + beta * (w.x * length(e2));
  return Bent(Cubic(c.p0, c.p1, p2, p2 + f3), turnAngle(e3, f3));
}

// Bends a placed piece by a force in metres and gives it its arc length at rest back, not in the paper's form
// (equations.md 3.4 and 5.5). weights: those of P2 and P3; third: a third of the stem's length.
Bent bendPiece(Cubic c, vec2 force, float third, vec2 weights, float arc) {
  vec3 beta = bendVector(force, third, windExponents.x, windExponents.y);
  if (windPaper) return paperBendStep(c, beta, weights);
  Bent bent = bendStep(c, beta, weights);
  return Bent(rescaleArc(bent.curve, arc), bent.angle);
}
#endif
