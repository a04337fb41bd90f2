// Grass and earth around a tree, fading into the sky. Fragment part of a Lambert material.
in vec3 vGround;

uniform sampler2D grassMap;
uniform vec3 grassLight;
uniform vec3 grassDark;
uniform vec3 earth;
uniform vec3 groundHaze;
// How far from the eye the ground begins and ends to fade, radius of the trunk's foot, radius of the crown above it; metres.
uniform vec4 groundReach;

vec3 groundDiffuse() {
  // Turned against the axes, or the noise's lattice would show as lines that run from the eye to the horizon.
  vec2 p = mat2(0.62, 0.785, -0.785, 0.62) * vGround.xz;
  vec4 broad = texture(grassMap, p * 0.061 + 0.37);
  // At a flat angle the mip level is that of the long side of a pixel; half of it keeps blades in the foreground.
  vec4 fine = texture(grassMap, p * 0.43, -1.0);
  float r = length(p);
  vec4 wide = texture(grassMap, p.yx * 0.0131 + 0.11);
  float tone = 0.45 + 1.1 * (fine.r - 0.5) + 0.7 * (broad.g - 0.5) + 0.75 * (wide.b - 0.5);
  vec3 c = mix(grassDark, grassLight, clamp(tone, 0.0, 1.0));
  // Little grows in the shade of the trunk.
  float bare = 1.0 - smoothstep(groundReach.z * 1.6, groundReach.z * 5.0, r + (broad.r - 0.5) * groundReach.z * 3.0);
  float patchy = smoothstep(0.62, 0.8, broad.b) * 0.35;
  return mix(c, earth * (0.7 + 0.6 * fine.g), max(bare * 0.85, patchy));
}

// Light of the sky that reaches the ground: less under the crown, least where the trunk meets it.
float groundSky() {
  float r = length(vGround.xz);
  float crown = 1.0 - smoothstep(0.0, 1.25, r / groundReach.w);
  float foot = groundReach.z / max(r, groundReach.z * 0.6);
  return (1.0 - 0.42 * crown) * (1.0 - 0.6 * foot * foot);
}

float groundFade() {
  return smoothstep(groundReach.x, groundReach.y, distance(vGround, cameraPosition));
}
