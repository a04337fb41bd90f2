// Grass and earth around a tree, fading into the fields far off. Fragment part of a Lambert material.
// GROUND_WILD: neither a tree in the middle nor a mower nor a path; what there is of them is left out, as compilers may leave it in.
in vec3 vGround;
in vec3 vHaze;

uniform sampler2D grassMap;
uniform vec3 grassLight;
uniform vec3 grassDark;
uniform vec3 earth;
// How far from the eye the ground begins and ends to fade, radius of the trunk's foot, radius of the crown above it; metres.
uniform vec4 groundReach;
// Reach of the tree in metres, how much grass stands up to the light.
uniform vec2 groundTree;
// How much the colour varies, earth that shows, stripes of a mower, a path; 0..1 each.
uniform vec4 groundLook;
// Direction on the ground in which shadows fall (x, z), their length a metre of height, width of their rim a metre of the light's way.
uniform vec4 groundShade;

#ifndef GROUND_WILD
// The path runs past the tree on the left, as the default camera sees it, and turns behind it: metres right of its middle.
float pathAway(vec2 p, float reach) {
  const vec2 away = vec2(-0.19866933, -0.98006658);
  float s = dot(p, away) / reach;
  float v = dot(p, vec2(-away.y, away.x));
  float middle = reach * (-0.46 + 0.05 * s + 0.055 * s * s * s);
  float slope = 0.05 + 0.165 * s * s;
  return (v - middle) * inversesqrt(1.0 + slope * slope);
}
#endif

vec3 groundDiffuse() {
  // Turned against the axes, or the noise's lattice would show as lines that run from the eye to the horizon.
  vec2 p = mat2(0.62, 0.785, -0.785, 0.62) * vGround.xz;
  vec4 broad = texture(grassMap, p * 0.061 + 0.37);
  // At a flat angle the mip level is that of the long side of a pixel; half of it keeps blades in the foreground.
  vec4 fine = texture(grassMap, p * 0.43, -1.0);
  vec4 wide = texture(grassMap, p.yx * 0.0131 + 0.11);
  float tone = 0.45 + 1.1 * (fine.r - 0.5) + 0.7 * (broad.g - 0.5) + 0.75 * (wide.b - 0.5);
  tone = mix(0.5, tone, groundLook.x);
#ifndef GROUND_WILD
  if (groundLook.z > 0.0) {
    float across = dot(vGround.xz, vec2(0.92, -0.39)) * 2.1;
    float stripe = sin(across + 0.5 * (broad.r - 0.5)) * clamp(1.0 - 0.5 * fwidth(across), 0.0, 1.0);
    tone += 0.2 * groundLook.z * stripe;
  }
#endif
  vec3 c = mix(grassDark, grassLight, clamp(tone, 0.0, 1.0));
  // Dry stalks here, clover there: a meadow is not of one green.
  c *= mix(vec3(1.0), mix(vec3(0.86, 0.98, 0.92), vec3(1.14, 1.02, 0.84), smoothstep(0.3, 0.7, wide.g)), groundLook.x);
  float patchy = smoothstep(0.62, 0.8, broad.b) * 0.35;
#ifdef GROUND_WILD
  float open = patchy * groundLook.y;
#else
  // Little grows in the shade of the trunk.
  float r = length(p);
  float bare = 1.0 - smoothstep(groundReach.z * 1.4, groundReach.z * 4.2, r + (broad.r - 0.5) * groundReach.z * 3.0 + (fine.r - 0.5) * groundReach.z * 1.6);
  float open = max(bare * 0.8, patchy) * groundLook.y;
  if (groundLook.w > 0.0) {
    // Far off a pixel is wider than the path: it takes as much of its colour as it covers of it.
    float path = pathAway(vGround.xz, groundTree.x);
    float wide = max(0.4, fwidth(path));
    float to = 1.25 - (broad.g - 0.5) * 0.9 - (fine.r - 0.5) * 0.35;
    float covered = min(path + 0.5 * wide, to) - max(path - 0.5 * wide, -to);
    open = max(open, groundLook.w * clamp(covered / wide, 0.0, 1.0));
  }
#endif
  return mix(c, earth * (0.7 + 0.6 * fine.g), open);
}

#ifndef GROUND_WILD
// Light of the sky that reaches the ground: less under the crown, least where the trunk meets it.
float groundSky() {
  float r = length(vGround.xz);
  float crown = 1.0 - smoothstep(0.0, 1.25, r / groundReach.w);
  float foot = groundReach.z / max(r, groundReach.z * 0.6);
  return (1.0 - 0.42 * crown) * (1.0 - 0.62 * foot * foot);
}

float groundFade() {
  return smoothstep(groundReach.x, groundReach.y, distance(vGround, cameraPosition));
}
#endif
