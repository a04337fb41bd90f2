#ifndef LEAF_ANSWER
#define LEAF_ANSWER
#include /leaf/matter.glsl

// What a leaf makes of a light, over the light: times its colour | gloss | times the colour of what comes through.
// Through it comes most where the sun stands on its other side, and more when one looks towards the sun.
vec3 leafAnswer(vec3 light, vec3 eye, vec3 normal, float roughness) {
  float facing = dot(normal, light);
  float lit = saturate(facing);
  float behind = saturate(-facing);
  float towards = saturate(-dot(eye, light));
  towards *= towards;
  float through = 0.5 * behind + 0.5 * towards * towards * (0.35 + 0.65 * behind);
  return vec3(lit * (LEAF_ENTERS * RECIPROCAL_PI), lit * gloss(light, eye, normal, roughness), through * RECIPROCAL_PI);
}
#endif
