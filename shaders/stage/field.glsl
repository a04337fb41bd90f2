#ifndef STAGE_FIELD
#define STAGE_FIELD
#include /wind/force.glsl
// The force over the ground for what shows it: the pass's own functions, summed in a loop, so that no fade and no gust asks for
// another program. Without the profile: at the ground itself no wind is left; it is shown as at the height that its numbers are of.

// Waves and gusts that blow.
uniform ivec2 fieldCounts;

// Metres, horizontal, tree axes.
vec2 fieldForce(vec2 xy) {
  vec2 force = vec2(0.0);
  for (int i = 0; i < fieldCounts.x; i++) force += wavePush(windWaves[i], windPhases[i], xy);
  for (int i = 0; i < fieldCounts.y; i++) force += gustForce(i, xy);
#if WIND_RECORD > 0
  force += recordForce(xy);
#endif
  return force;
}
#endif
