in vec4 colour;
out vec4 fragment;

void main() {
  // Colours are linear; no tone mapping, so that they stay what the legend says.
  fragment = vec4(mix(colour.rgb * 12.92, 1.055 * pow(max(colour.rgb, vec3(1e-5)), vec3(0.41666)) - 0.055, step(0.0031308, colour.rgb)), colour.a);
}
