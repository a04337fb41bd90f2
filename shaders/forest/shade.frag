// Leaves what gets through: blended by multiplying, so that crowns over crowns darken as leaves over leaves do.
in vec2 vCorner;
in vec2 vTaken;
out vec4 fragment;

void main() {
  float r = length(vCorner);
  float body = 1.0 - smoothstep(0.45, 1.0, r);
  fragment = vec4(1.0 - vTaken * body, 1.0, 1.0);
}
