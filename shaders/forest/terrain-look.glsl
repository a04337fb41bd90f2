#ifndef FOREST_TERRAIN_LOOK
#define FOREST_TERRAIN_LOOK
// What the ground of a forest has besides the meadow's: slopes, a floor of litter under dense trees, shade from afar, haze.
// TERRAIN_WITHIN: nothing is drawn but what lies within the forest's square. TERRAIN_MESH: it is the ground itself that is drawn, whose
// vertices bring what changes slowly.
#define GROUND_WILD
#include /stage/ground.glsl
#include /forest/terrain-slow.glsl

in vec2 vTerrain;
#ifdef TERRAIN_MESH
// How much the haze takes, 0..1 | 0, or the widest patches where all lies within.
in vec2 vSlow;
#endif

// Normal of the ground: x and y as n / 2 + 1/2, forest space.
uniform sampler2D terrainNormals;
// Part of the sunlight that trees let through to the ground, part of the sky that they leave open.
uniform sampler2D terrainShade;
uniform vec3 terrainPlace;
// Colour of what lies under the trees, linear.
uniform vec3 terrainLitter;

vec2 terrainUv() {
  return vTerrain * terrainPlace.x + 0.5;
}

// 1 within the square, 0 well outside.
float terrainInside() {
#ifdef TERRAIN_WITHIN
  return 1.0;
#else
  vec2 away = abs(vTerrain) * terrainPlace.x - 0.5;
  return 1.0 - smoothstep(0.0, 0.02, max(away.x, away.y));
#endif
}

// What several steps of the shading ask for is read once.
vec3 terrainUp;
vec2 terrainLight;
// Part of the sky that woods outside take.
float terrainWoods;

vec3 readUp() {
  vec2 xy = texture(terrainNormals, terrainUv()).rg * 2.0 - 1.0;
#ifndef TERRAIN_WITHIN
  vec2 away = max(abs(vTerrain) * terrainPlace.x - 0.5, 0.0);
  xy *= 1.0 - smoothstep(0.0, 1.3, length(away));
#endif
  return vec3(xy, sqrt(max(0.05, 1.0 - dot(xy, xy))));
}

// Sunlight that is left, and open sky.
vec2 readLight() {
  vec2 light = texture(terrainShade, terrainUv()).rg;
#ifdef TERRAIN_WITHIN
  return light;
#else
  // Outside nothing is known: open land with woods in it, as the skyline has. From near by they would be stains: no tree stands there.
  vec4 woods = texture(grassMap, vTerrain * 0.0017 + 0.31);
  float wood = smoothstep(0.46, 0.6, woods.b) * 0.8 * smoothstep(120.0, 480.0, distance(vGround, cameraPosition));
  terrainWoods = wood * (1.0 - terrainInside());
  return mix(vec2(1.0 - 0.6 * wood, 1.0 - wood), light, terrainInside());
#endif
}

// Reads what the others need: comes first.
vec3 terrainDiffuse() {
  terrainUp = readUp();
  terrainLight = readLight();
  vec3 c = groundDiffuse();
  mat2 turned = mat2(0.83, -0.56, 0.56, 0.83);
#if defined(TERRAIN_MESH) && defined(TERRAIN_WITHIN)
  float wide = vSlow.y;
#else
  float wide = texture(grassMap, terrainWide(vTerrain)).b;
#endif
  vec4 broad = texture(grassMap, turned * vTerrain * 0.037 + 0.71);
  c *= mix(vec3(0.8, 0.88, 0.86), vec3(1.18, 1.08, 0.96), wide);
  float steep = 1.0 - terrainUp.z;
  c = mix(c, earth * (0.5 + 0.8 * broad.r), 0.8 * smoothstep(0.16, 0.34, steep + 0.16 * (broad.g - 0.5)));
  float under = 1.0 - terrainLight.y;
  float litter = smoothstep(0.3, 0.85, under + 0.45 * (broad.g - 0.5) + 0.25 * (broad.r - 0.5));
  vec3 floor_ = terrainLitter * (0.55 + 0.9 * broad.r);
#ifndef TERRAIN_WITHIN
  // Woods far outside are seen from above: crowns, not what lies under them.
  floor_ = mix(floor_, grassDark * (0.35 + 0.3 * broad.r), min(1.0, terrainWoods / max(under, 1e-3)));
#endif
  return mix(c, floor_, 0.85 * litter);
}

// A blade: at its foot as the ground, at its tip (1) mostly that in more light, so that it stands out of no patch. tone: about 1.
vec3 terrainBlade(vec3 ground, float tone, float tip) {
  return mix(0.82 * ground, mix(1.25 * ground, grassLight, 0.35) * tone, tip);
}

// Light of the sky that gets through the crowns.
float terrainSky() {
  return mix(0.5, 1.0, terrainLight.y);
}

float terrainFade() {
#ifdef TERRAIN_MESH
  return vSlow.x;
#else
  return terrainHaze(distance(vGround, cameraPosition), groundReach.xy);
#endif
}
#endif
