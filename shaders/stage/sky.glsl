#ifndef STAGE_SKY
#define STAGE_SKY
// The sky as a gradient with a glow around the sun. Colours are those of the screen: the ground fades into them exactly.
uniform vec3 skyHorizon;
uniform vec3 skyMiddle;
uniform vec3 skyZenith;
uniform vec3 skyGlow;
uniform vec3 glowDirection;
// Fields at the foot of the skylines, and how much of their colour the air leaves.
uniform vec4 skyField;

vec3 skyColour(vec3 direction) {
  float up = max(direction.y, 0.0);
  vec3 c = mix(skyHorizon, skyMiddle, smoothstep(0.0, 0.28, up));
  c = mix(c, skyZenith, smoothstep(0.12, 0.9, up));
  float near = max(dot(direction, glowDirection), 0.0);
  float n4 = near * near;
  n4 *= n4;
  // Wide through the whole sky, close around the sun, and along the horizon, where there is most air.
  float along = n4 * exp(-7.0 * up);
  // As light on light: it nears white and never clips.
  vec3 glow = skyGlow * (0.3 * n4 + 0.6 * pow(near, 36.0) + 0.4 * along);
  return 1.0 - (1.0 - c) * exp(-glow);
}

// What lies between the end of the ground and the horizon.
vec3 farField(vec3 direction) {
  vec3 level = normalize(vec3(direction.x, 1e-4, direction.z));
  return mix(skyColour(level), skyField.rgb, skyField.a);
}
#endif
