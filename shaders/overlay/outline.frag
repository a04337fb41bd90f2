in vec3 vMark;
out vec4 fragment;

uniform vec3 inkColour;
uniform vec3 paperColour;
uniform vec3 stemColour;
uniform float overlayAlpha;
// How strongly it is drawn, 0..1: what is selected more than what is pointed at.
uniform float outlineWeight;

void main() {
  // From the bark outwards: paper, a line of the level's colour, paper. What it lies on may be bark, leaves or sky.
  float out_ = abs(vMark.x) - vMark.y;
  float brim = vMark.z - vMark.y;
  float ring = smoothstep(-0.4, 0.6, out_) * (1.0 - smoothstep(brim - 1.2, brim, out_));
  float line = smoothstep(0.6, 1.3, out_) * (1.0 - smoothstep(mix(1.7, 2.8, outlineWeight), mix(2.4, 3.6, outlineWeight), out_));
  vec3 colour = mix(paperColour, mix(inkColour, stemColour, 0.75), line);
  float veil = (1.0 - smoothstep(-0.5, 0.5, out_)) * 0.3 * outlineWeight;
  vec3 all = mix(stemColour, colour, ring);
  fragment = vec4(all, max(ring * mix(0.5, 0.95, outlineWeight), veil) * overlayAlpha);
}
