// One view of a tree, drawn finely, as a cell of its atlas: colours of what covers a texel, how much of it is covered, and colours
// beyond the rim, so that nothing dark is filtered in.
uniform sampler2D viewColour;
uniform sampler2D viewShape;
// Mip level of the view whose texels are as large as the cell's.
uniform float level;
// Part of the cell that the view fills; the rest is the gutter.
uniform float filled;

in vec2 vUv;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 shape;

void main() {
  vec2 uv = (vUv - 0.5) / filled + 0.5;
  bool outside = any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)));
  vec4 c = textureLod(viewColour, uv, level);
  vec4 s = textureLod(viewShape, uv, level);
  float covered = outside ? 0.0 : c.a;
  float l = level;
  for (int i = 0; i < 8; i++) {
    if (c.a >= 0.05) break;
    l += 1.0;
    c = textureLod(viewColour, uv, l);
    s = textureLod(viewShape, uv, l);
  }
  if (c.a < 0.004) {
    colour = vec4(0.05, 0.06, 0.03, 0.0);
    shape = vec4(0.5, 0.5, 0.5, 0.6);
    return;
  }
  colour = vec4(c.rgb / c.a, covered);
  shape = s / c.a;
}
