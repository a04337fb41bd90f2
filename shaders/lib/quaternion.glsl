#ifndef LIB_QUATERNION
#define LIB_QUATERNION
// Rotations as unit quaternions (x, y, z, w). Twin: src/core/math/quaternion.ts

// v turned by q.
vec3 rotateByQuaternion(vec4 q, vec3 v) {
  return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

// The rotation q as a matrix; its columns are the turned axes.
mat3 matrixFromQuaternion(vec4 q) {
  vec3 d = 2.0 * q.xyz;
  vec3 s = d * q.xyz; // 2xx, 2yy, 2zz
  vec3 m = d.xyz * q.yzx; // 2xy, 2yz, 2zx
  vec3 w = d * q.w;
  return mat3(
    1.0 - s.y - s.z, m.x + w.z, m.z - w.y,
    m.x - w.z, 1.0 - s.x - s.z, m.y + w.x,
    m.z + w.y, m.y - w.x, 1.0 - s.x - s.y
  );
}
#endif
