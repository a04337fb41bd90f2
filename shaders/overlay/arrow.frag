in vec4 vArrow;
out vec4 fragment;

uniform vec3 forceColour;
uniform vec3 forceGlow;
uniform float overlayAlpha;

void main() {
  // From a breath at the tail to full at the tip; stronger wind speaks louder.
  float along = clamp(vArrow.x, 0.0, 1.0);
  float alpha = mix(0.12, 1.0, smoothstep(0.0, 0.85, along)) * mix(0.45, 0.95, vArrow.z) * vArrow.w;
  fragment = vec4(mix(forceGlow, forceColour, smoothstep(0.0, 0.6, vArrow.z + 0.3 * along)), alpha * overlayAlpha);
}
