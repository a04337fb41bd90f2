#ifndef LIB_BEZIER
#define LIB_BEZIER
// Cubic Bezier curves; u in 0..1 along the curve, lengths in the unit of the control points. Twin: src/core/math/bezier.ts

struct Cubic {
  vec3 p0;
  vec3 p1;
  vec3 p2;
  vec3 p3;
};

// (1-u)^2 a + 2u(1-u) b + u^2 c by de Casteljau's steps.
vec3 quadraticBlend(vec3 a, vec3 b, vec3 c, float u) {
  return mix(mix(a, b, u), mix(b, c, u), u);
}

// The point of the curve at u.
vec3 bezierPoint(Cubic c, float u) {
  return mix(quadraticBlend(c.p0, c.p1, c.p2, u), quadraticBlend(c.p1, c.p2, c.p3, u), u);
}

// dC/du: three times the blend of the edges.
vec3 bezierDerivative(Cubic c, float u) {
  return 3.0 * quadraticBlend(c.p1 - c.p0, c.p2 - c.p1, c.p3 - c.p2, u);
}

// d2C/du2.
vec3 bezierSecondDerivative(Cubic c, float u) {
  return 6.0 * mix((c.p2 - c.p1) - (c.p1 - c.p0), (c.p3 - c.p2) - (c.p2 - c.p1), u);
}

// Arc length by 5-point Gauss-Legendre (equations.md 3.4): within 4e-5 of it for equal edges and bends up to 90 degrees.
float bezierArcLength(Cubic c) {
  vec3 a = 3.0 * (c.p1 - c.p0);
  vec3 b = 3.0 * (c.p2 - c.p1);
  vec3 d = 3.0 * (c.p3 - c.p2);
  return 0.2844444444 * length(quadraticBlend(a, b, d, 0.5))
    + 0.2393143352 * (length(quadraticBlend(a, b, d, 0.2307653449)) + length(quadraticBlend(a, b, d, 0.7692346551)))
    + 0.1184634425 * (length(quadraticBlend(a, b, d, 0.0469100770)) + length(quadraticBlend(a, b, d, 0.9530899230)));
}

// The curve scaled about P0 to the arc length `rest`: edge directions stay, so the joint with the parent stays smooth.
Cubic rescaleArc(Cubic c, float rest) {
  float arc = bezierArcLength(c);
  float s = arc > 0.0 ? rest / arc : 1.0;
  return Cubic(c.p0, c.p0 + (c.p1 - c.p0) * s, c.p0 + (c.p2 - c.p0) * s, c.p0 + (c.p3 - c.p0) * s);
}
#endif
