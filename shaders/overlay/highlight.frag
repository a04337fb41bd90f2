in vec2 vMark;
out vec4 fragment;

uniform vec3 answerColour;
uniform vec3 paperColour;
uniform float overlayAlpha;

void main() {
  // Green with a brim of paper: it is told from bark and from leaves.
  float inward = vMark.y - abs(vMark.x);
  float alpha = smoothstep(0.0, 1.0, inward);
  float brim = 1.0 - smoothstep(1.2, 2.2, inward);
  fragment = vec4(mix(answerColour, paperColour, brim), alpha * mix(0.9, 0.7, brim) * overlayAlpha);
}
