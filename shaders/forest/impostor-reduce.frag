// Half as many texels: what covers more of a texel counts for more of its colour.
uniform sampler2D fineColour;
uniform sampler2D fineShape;

layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 shape;

void main() {
  ivec2 at = 2 * ivec2(gl_FragCoord.xy);
  vec3 rgb = vec3(0.0);
  vec4 s = vec4(0.0);
  float covered = 0.0;
  float sum = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 texel = at + ivec2(i & 1, i >> 1);
    vec4 c = texelFetch(fineColour, texel, 0);
    float weight = c.a + 0.02;
    rgb += weight * c.rgb;
    s += weight * texelFetch(fineShape, texel, 0);
    covered += 0.25 * c.a;
    sum += weight;
  }
  colour = vec4(rgb / sum, covered);
  shape = s / sum;
}
