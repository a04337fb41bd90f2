#ifndef BRANCH_SURFACE
#define BRANCH_SURFACE
#include /lib/frames.glsl
// From (u, angle) and a radius to a point of the bent surface. Metres, tree space; theta = 0 on the side of T, a quarter turn
// on that of S. Twin: src/core/deform/surface.ts

// normal points outward; around is the direction of growing theta (texture s), along that of growing u (texture t).
struct SurfacePoint {
  vec3 position;
  vec3 normal;
  vec3 around;
  vec3 along;
};

// The surface with sections that are exact circles (equations.md 3.2 in place of Skjermo 2006, equation 9, erratum E19).
// rho: radius; rhoU: its derivative by u; q: (d rho/d theta)/rho. Finite for rho = 0 and where control points coincide.
SurfacePoint surfacePoint(
  Cubic curve, Handles h, float u, float cosTheta, float sinTheta, float rho, float rhoU, float q
) {
  mat3 frame = sectionFrame(curve, h, u);
  vec3 radial = sinTheta * frame[2] + cosTheta * frame[1];
  vec3 turn = cosTheta * frame[2] - sinTheta * frame[1];
  float g0 = max(length(bezierDerivative(curve, u)), 1e-6 * length(curve.p3 - curve.p0));
  // dU . radial = (C'' - U (U . C'')) . radial / speed, and U . radial = 0.
  float bend = g0 > 0.0 ? dot(bezierSecondDerivative(curve, u), radial) / g0 : 0.0;
  float g = max(g0 - rho * bend, 0.01 * g0);
  vec3 n = g * radial - rhoU * frame[0] - g * q * turn;
  return SurfacePoint(
    bezierPoint(curve, u) + rho * radial,
    unitOr(n, radial),
    unitOr(turn + q * radial, turn),
    unitOr(g * frame[0] + rhoU * radial, frame[0])
  );
}

// The paper's mapping of (u, v on S, w on T) through the handles, with its partial derivatives.
struct Deformed {
  vec3 position;
  vec3 byU;
  vec3 byV;
  vec3 byW;
};

// Generalised de Casteljau (Skjermo 2006, equations 9 and 16, errata E8 and E14 to E17).
Deformed deform(Cubic curve, Handles h, float u, float v, float w) {
  vec3 s0 = cross(h.l0, h.t0);
  vec3 s1 = cross(h.l1, h.t1);
  vec3 s2 = cross(h.l2, h.t2);
  vec3 byV = quadraticBlend(s0, s1, s2, u);
  vec3 byW = quadraticBlend(h.t0, h.t1, h.t2, u);
  vec3 slopeV = 2.0 * mix(s1 - s0, s2 - s1, u);
  vec3 slopeW = 2.0 * mix(h.t1 - h.t0, h.t2 - h.t1, u);
  return Deformed(
    bezierPoint(curve, u) + v * byV + w * byW,
    bezierDerivative(curve, u) + v * slopeV + w * slopeW,
    byV,
    byW
  );
}

// The surface as the paper makes it, with sections that shrink in the plane of a bend; for teaching
// (Skjermo 2006, equations 9, 13 and 16, errata E10, E13, E18).
SurfacePoint paperSurfacePoint(
  Cubic curve, Handles h, float u, float cosTheta, float sinTheta, float rho, float rhoU, float q
) {
  Deformed d = deform(curve, h, u, rho * sinTheta, rho * cosTheta);
  vec3 radial = sinTheta * d.byV + cosTheta * d.byW;
  vec3 along = d.byU + rhoU * radial;
  vec3 turn = (cosTheta + q * sinTheta) * d.byV + (q * cosTheta - sinTheta) * d.byW;
  vec3 n = cross(turn, along);
  vec3 normal = dot(n, n) > 1e-18 ? unitOr(n, h.t0) : unitOr(radial, h.t0);
  return SurfacePoint(
    d.position,
    dot(normal, radial) < 0.0 ? -normal : normal,
    unitOr(turn, cross(h.l0, h.t0)),
    unitOr(along, h.l0)
  );
}
#endif
