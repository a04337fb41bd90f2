in vec2 vMark;
out vec4 fragment;

uniform vec3 answerColour;
uniform vec3 paperColour;
uniform float overlayAlpha;

// 1 inside of a ring from a to b pixels.
float ring(float r, float a, float b) {
  return smoothstep(a - 0.6, a + 0.6, r) * (1.0 - smoothstep(b - 0.6, b + 0.6, r));
}

void main() {
  float r = length(vMark);
  float paper = max(ring(r, 5.0, 11.5), 1.0 - smoothstep(4.0, 5.2, r));
  float ink = max(ring(r, 7.0, 9.8), 1.0 - smoothstep(2.4, 3.4, r));
  fragment = vec4(mix(paperColour, answerColour, ink), max(ink, 0.85 * paper) * overlayAlpha);
}
