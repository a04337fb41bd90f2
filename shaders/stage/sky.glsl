#ifndef STAGE_SKY
#define STAGE_SKY
// The sky as a gradient with haze around the sun. Colours are those of the screen: the ground fades into them exactly.
uniform vec3 skyHorizon;
uniform vec3 skyMiddle;
uniform vec3 skyZenith;
uniform vec3 skySun;
uniform vec3 sunDirection;

vec3 skyColour(vec3 direction) {
  float up = max(direction.y, 0.0);
  vec3 c = mix(skyHorizon, skyMiddle, smoothstep(0.0, 0.28, up));
  c = mix(c, skyZenith, smoothstep(0.12, 0.9, up));
  float near = max(dot(direction, sunDirection), 0.0);
  float n4 = near * near;
  n4 *= n4;
  // The sun itself stays outside the picture most of the time; its haze warms that side of the sky.
  return c + skySun * (0.30 * n4 + 0.5 * pow(near, 48.0)) * smoothstep(-0.05, 0.12, direction.y);
}
#endif
