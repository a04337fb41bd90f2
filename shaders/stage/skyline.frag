// The band of the sky in which skylines stand, and the fields at their foot.
in vec3 vDirection;
in vec3 vSky;
out vec4 fragment;

uniform sampler2D cloudMap;
// Heights of four skylines around the viewer, 0..1, the farthest first.
uniform sampler2D ridgeMap;
uniform vec4 skyline;
// Colour of each skyline, and how much of it the air leaves.
uniform vec4 hillColour[4];
uniform vec4 skyField;

// One skyline before what is behind it; mist lies at its foot.
vec3 hill(vec3 behind, vec4 colour, float height, float up, float soft, float leaves) {
  float inside = 1.0 - smoothstep(height - soft, height + soft, up);
  float clear = colour.a * mix(0.8, 1.0, smoothstep(0.0, 0.9, up / max(height, 1e-4)));
  return mix(behind, mix(vSky, colour.rgb * (1.0 + leaves), clear), inside);
}

void main() {
  float up = vDirection.y;
  vec3 c = vSky;
  float around = atan(vDirection.x, vDirection.z) * 0.15915494;
  vec4 height = textureLod(ridgeMap, vec2(around, 0.5), 0.0) * skyline;
  float soft = fwidth(up);
  // Twigs at the rim of the woods, light and shade within.
  float leaves = texture(cloudMap, vec2(around * 46.0, up * 13.0)).r - 0.5;
  for (int i = 0; i < 4; i++) {
    float wood = i < 2 ? 0.0 : leaves;
    float high = height[i] + 0.3 * wood * min(height[i], 0.02);
    if (skyline[i] > 0.0) c = hill(c, hillColour[i], high, up, soft + 0.0003, 0.55 * wood);
  }
  vec3 field = mix(vSky, skyField.rgb, skyField.a);
  c = mix(c, field, 1.0 - smoothstep(-soft, soft, up - 0.0006));
  // Half a step of noise keeps the gradient from banding.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  fragment = vec4(c + (noise - 0.5) / 255.0, 1.0);
}
