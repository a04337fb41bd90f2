// The pruning envelope: lines of a body of revolution, and the veil between them. Tree space.
// mark: direction of the line | side -1 or 1, twice that on the widest ring, 0 on the veil.
#include /overlay/screen.glsl

in vec4 mark;

// Across the line in pixels | 0 veil, 1 line, 2 the widest ring | cosine between the outside and the eye
out vec3 vMark;

void main() {
  vec4 at = onScreen(position);
  float kind = abs(mark.w);
  vMark.y = kind;
  vec3 eye = normalize((modelViewMatrix * vec4(position, 1.0)).xyz);
  vMark.z = -dot(eye, normalize(mat3(modelViewMatrix) * normal));
  vMark.x = 0.0;
  gl_Position = at;
  if (kind > 0.5) {
    vec2 way = screenWay(at, onScreen(position + 0.02 * mark.xyz));
    vMark.x = sign(mark.w) * (kind > 1.5 ? 3.0 : 2.4);
    gl_Position = movedBy(at, vec2(-way.y, way.x) * vMark.x);
  }
}
