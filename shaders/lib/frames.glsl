#ifndef LIB_FRAMES
#define LIB_FRAMES
#include /lib/bezier.glsl
// Handles and cross-section frames of a cubic (Skjermo 2006, equation 8, and equations.md sections 2 and 3.2).
// Twin: src/core/math/frames.ts

// Unit vectors along the three control edges, and one across each; S_i = L_i x T_i completes the paper's handles.
struct Handles {
  vec3 l0;
  vec3 l1;
  vec3 l2;
  vec3 t0;
  vec3 t1;
  vec3 t2;
};

// The vector of length 1 along a, or `fallback` where a is shorter than 1e-12. Twin: src/core/math/vec3.ts (unit)
vec3 unitOr(vec3 a, vec3 fallback) {
  float n = length(a);
  return n < 1e-12 ? fallback : a / n;
}

// The world axis with the smallest part along the unit vector l.
vec3 leastAxis(vec3 l) {
  vec3 m = abs(l);
  bool x = m.x <= m.y && m.x <= m.z;
  bool y = !x && m.y <= m.z;
  return vec3(x ? 1.0 : 0.0, y ? 1.0 : 0.0, x || y ? 0.0 : 1.0);
}

// The unit vector at right angles to the unit vector l that is nearest to a; where a lies along l, any that is steady.
// Chooses and normalises once: a branch would run both of its sides on software GL.
vec3 across(vec3 l, vec3 a) {
  vec3 d = a - l * dot(l, a);
  vec3 b = leastAxis(l);
  d = dot(d, d) > 1e-6 * dot(a, a) + 1e-30 ? d : b - l * dot(l, b);
  return d * inversesqrt(dot(d, d));
}

// a, at right angles to the unit vector p, carried along the shortest rotation from p to the unit vector q; where q is -p
// within 1e-4 there is none, and a is projected. Parallel transport in place of equation 8's projection (erratum E12),
// which for such an a is a - (p + q) (q . a) / (1 + p . q).
vec3 transport(vec3 a, vec3 p, vec3 q) {
  float c = 1.0 + dot(p, q);
  return across(q, c < 1e-4 ? a : a - (p + q) * (dot(q, a) / c));
}

// Directions of the control edges as columns; an edge without length takes the next that has one.
mat3 edgesOf(Cubic curve) {
  vec3 a = curve.p1 - curve.p0;
  vec3 b = curve.p2 - curve.p1;
  vec3 c = curve.p3 - curve.p2;
  vec3 n = vec3(length(a), length(b), length(c));
  float tiny = 1e-6 * (n.x + n.y + n.z);
  vec3 z = vec3(0.0, 0.0, 1.0);
  vec3 l2 = n.z > tiny ? c / n.z : unitOr(n.y > tiny ? b : a, z);
  vec3 l1 = n.y > tiny ? b / n.y : unitOr(curve.p2 - curve.p0, l2);
  return mat3(n.x > tiny ? a / n.x : l1, l1, l2);
}

// The handles of a curve with the orientation vector o, transported from edge to edge: smooth below 180 degrees a joint.
Handles handlesOf(Cubic curve, vec3 o) {
  mat3 l = edgesOf(curve);
  vec3 t0 = across(l[0], o);
  vec3 t1 = transport(t0, l[0], l[1]);
  return Handles(l[0], l[1], l[2], t0, t1, transport(t1, l[1], l[2]));
}

// The handles as equation 8 prints them, T_i = S_(i-1) x L_i, made unit vectors: they twist and flip (E9, E12); for teaching.
Handles projectedHandlesOf(Cubic curve, vec3 o) {
  mat3 l = edgesOf(curve);
  vec3 t0 = across(l[0], o);
  vec3 t1 = across(l[1], cross(cross(l[0], t0), l[1]));
  return Handles(l[0], l[1], l[2], t0, t1, across(l[2], cross(cross(l[1], t1), l[2])));
}

// The unit tangent at u; where the derivative vanishes, the chord's direction, or L0 of a point.
vec3 tangentAt(Cubic curve, Handles h, float u) {
  vec3 d = bezierDerivative(curve, u);
  vec3 chord = curve.p3 - curve.p0;
  return unitOr(dot(d, d) > 1e-12 * dot(chord, chord) ? d : chord, h.l0);
}

// The frame of the cross-section at u: columns U (along), T^ and S^ = U x T^, orthonormal (equations.md 3.2).
mat3 sectionFrame(Cubic curve, Handles h, float u) {
  vec3 along = tangentAt(curve, h, u);
  vec3 t = across(along, quadraticBlend(h.t0, h.t1, h.t2, u));
  return mat3(along, t, cross(along, t));
}
#endif
