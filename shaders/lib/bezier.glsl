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

// The square of the speed |dC/du|/3 as a quartic in Bernstein form: q and e its coefficients, w and v their weights.
float quarticRoot(vec4 q, float e, vec4 w, float v) {
  return sqrt(max(dot(q, w) + e * v, 0.0));
}

// Arc length by 5-point Gauss-Legendre on both halves, within 1e-4 of it as long as neighbouring edges turn by at most 105 degrees; one
// half alone, as equations.md 3.4 has it, misses by 1 % there. From the edges' products: cheaper than ten derivatives.
float arcLength(Cubic c) {
  vec3 a = c.p1 - c.p0;
  vec3 b = c.p2 - c.p1;
  vec3 d = c.p3 - c.p2;
  vec4 q = vec4(dot(a, a), dot(a, b), (dot(a, d) + 2.0 * dot(b, b)) / 3.0, dot(b, d));
  float e = dot(d, d);
  return 0.1776951638 * (
      quarticRoot(q, e, vec4(0.9094293675, 0.0873721198, 0.0031478066, 0.0000504035), 0.0000003027)
      + quarticRoot(q, e, vec4(0.0750788372, 0.2734022138, 0.3733513994, 0.2265953650), 0.0515721846)
      + quarticRoot(q, e, vec4(0.0515721846, 0.2265953650, 0.3733513994, 0.2734022138), 0.0750788372)
      + quarticRoot(q, e, vec4(0.0000003027, 0.0000504035, 0.0031478066, 0.0873721198), 0.9094293675)
    )
    + 0.3589715029 * (
      quarticRoot(q, e, vec4(0.6123810846, 0.3194970929, 0.0625091109, 0.0054354714), 0.0001772403)
      + quarticRoot(q, e, vec4(0.1434105344, 0.3585292790, 0.3361239582, 0.1400527989), 0.0218834295)
      + quarticRoot(q, e, vec4(0.0218834295, 0.1400527989, 0.3361239582, 0.3585292790), 0.1434105344)
      + quarticRoot(q, e, vec4(0.0001772403, 0.0054354714, 0.0625091109, 0.3194970929), 0.6123810846)
    )
    + 0.4266666667 * (
      quarticRoot(q, e, vec4(0.3164062500, 0.4218750000, 0.2109375000, 0.0468750000), 0.0039062500)
      + quarticRoot(q, e, vec4(0.0039062500, 0.0468750000, 0.2109375000, 0.4218750000), 0.3164062500)
    );
}

// The curve scaled about P0 to the arc length `rest`: edge directions stay, so the joint with the parent stays smooth.
Cubic holdArc(Cubic c, float rest) {
  float arc = arcLength(c);
  float s = arc > 0.0 ? rest / arc : 1.0;
  return Cubic(c.p0, c.p0 + (c.p1 - c.p0) * s, c.p0 + (c.p2 - c.p0) * s, c.p0 + (c.p3 - c.p0) * s);
}
#endif
