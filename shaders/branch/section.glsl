#ifndef BRANCH_SECTION
#define BRANCH_SECTION
#include /branch/read-pose.glsl
// The cross-section of a posed piece, in as few steps as a vertex can do it: the same as handlesOf and sectionFrame of
// lib/frames.glsl for pieces whose edges have a length and whose orientation vector lies across the first of them, as all do
// that the wind pass writes. Twins: src/core/math/frames.ts, src/core/deform/surface.ts; crosscheck.html compares the drawn
// vertices with them.

// Point of the axis; unit tangent, T^ and S^ = U x T^; |C'|; and C''.
struct Section {
  vec3 centre;
  vec3 along;
  vec3 t;
  vec3 s;
  float speed;
  vec3 second;
};

// a, across the unit vector p, carried along the shortest rotation from p to the unit vector q (equations.md 2).
vec3 carry(vec3 a, vec3 p, vec3 q) {
  return a - (p + q) * (dot(q, a) / max(1.0 + dot(p, q), 1e-4));
}

Section sectionAt(Pose pose, float v) {
  Cubic c = pose.curve;
  vec3 e0 = c.p1 - c.p0;
  vec3 e1 = c.p2 - c.p1;
  vec3 e2 = c.p3 - c.p2;
  vec3 lengths = vec3(dot(e0, e0), dot(e1, e1), dot(e2, e2));
  vec3 inverse = inversesqrt(max(lengths, vec3(1e-20)));
  vec3 l0 = e0 * inverse.x;
  vec3 l1 = lengths.y > 1e-20 ? e1 * inverse.y : l0;
  vec3 l2 = lengths.z > 1e-20 ? e2 * inverse.z : l1;
  vec3 t0 = pose.across;
  vec3 t1 = carry(t0, l0, l1);
  vec3 t2 = carry(t1, l1, l2);
  float w = 1.0 - v;
  vec3 b = vec3(w * w, 2.0 * w * v, v * v);
  vec3 third = b.x * e0 + b.y * e1 + b.z * e2;
  float size = inversesqrt(max(dot(third, third), 1e-20));
  vec3 along = third * size;
  vec3 t = b.x * t0 + b.y * t1 + b.z * t2;
  t -= along * dot(along, t);
  t *= inversesqrt(max(dot(t, t), 1e-20));
  return Section(
    b.x * c.p0 + b.y * c.p1 + b.z * c.p2 + v * third,
    along,
    t,
    cross(along, t),
    3.0 / size,
    6.0 * (w * (e1 - e0) + v * (e2 - e1))
  );
}
#endif
