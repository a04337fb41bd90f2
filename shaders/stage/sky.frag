in vec3 vDirection;
in vec3 vSky;
out vec4 fragment;

uniform sampler2D cloudMap;
uniform float cloudCover;
uniform vec3 cloudColour;
uniform float starAmount;
uniform vec3 discColour;
uniform vec3 discDirection;

#ifdef STARS
float stars(vec3 d) {
  vec3 p = d * 110.0;
  vec3 cell = floor(p);
  float own = fract(sin(dot(cell, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
  float far = length(p - cell - 0.5);
  return step(0.983, own) * smoothstep(0.32, 0.0, far) * fract(own * 917.0);
}
#endif

void main() {
  float up = vDirection.y;
  float over = max(up, 0.0);
  // Thin cloud on a plane overhead; it dissolves towards the horizon, where the plane runs away.
  float cloud = texture(cloudMap, vDirection.xz * (0.32 / (over + 0.35))).r;
  float covered = cloudCover * clamp(cloud * 2.1 - 0.88, 0.0, 1.0) * clamp(over * 3.6 - 0.07, 0.0, 1.0);
  vec3 c = mix(vSky, cloudColour, covered);
  float near = dot(vDirection, discDirection);
  if (near > 0.999) c += discColour * smoothstep(0.99985, 0.99996, near) * (1.0 - 0.7 * covered);
#ifdef STARS
  c += 1.1 * starAmount * stars(vDirection) * (1.0 - covered) * smoothstep(0.03, 0.3, up);
#endif
  // Half a step of noise keeps the gradient from banding.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  fragment = vec4(c + (noise - 0.5) / 255.0, 1.0);
}
