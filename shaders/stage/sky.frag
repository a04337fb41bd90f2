in vec3 vDirection;
in vec3 vSky;
out vec4 fragment;

uniform sampler2D cloudMap;
uniform float cloudCover;
uniform vec3 cloudColour;

void main() {
  // Thin cloud on a plane overhead; it dissolves towards the horizon, where the plane runs away.
  float up = max(vDirection.y, 0.0);
  float cloud = texture(cloudMap, vDirection.xz * (0.32 / (up + 0.35))).r;
  vec3 c = mix(vSky, cloudColour, cloudCover * clamp(cloud * 2.1 - 0.88, 0.0, 1.0) * clamp(up * 3.6 - 0.07, 0.0, 1.0));
  // Half a step of noise keeps the gradient from banding.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  fragment = vec4(c + (noise - 0.5) / 255.0, 1.0);
}
