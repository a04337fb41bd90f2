// A level of the atlas as it is kept. Colours: alpha scaled so that a test at a half cuts at the cell's threshold.
uniform sampler2D fineColour;
uniform sampler2D thresholds;
uniform float scaled;
// Texels along the side of a cell.
uniform int cell;

out vec4 stored;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 c = texelFetch(fineColour, texel, 0);
  float t = texelFetch(thresholds, texel / cell, 0).r;
  stored = scaled > 0.5 ? vec4(c.rgb, clamp(c.a * 0.5 / max(t, 0.02), 0.0, 1.0)) : c;
}
