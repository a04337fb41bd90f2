// Covers the whole viewport.
in vec3 position;
out vec2 vUv;

void main() {
  vUv = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
