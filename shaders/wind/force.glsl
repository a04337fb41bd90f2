#ifndef WIND_FORCE
#define WIND_FORCE
#include /lib/trig.glsl
// force: what the wind does at a place. Twin: src/core/wind/force.ts (wavesAt fills the uniforms)

// Waves in use, 0..8.
uniform int windCount;
// Direction x, y (unit, tree space), peak in metres, sharpness k.
uniform vec4 windWaves[8];
// Turns a metre, phase in turns: the sine's argument is x * (direction . position) - y.
uniform vec2 windPhases[8];

// Force at xy in tree space: metres of displacement, horizontal. Each wave pushes along its direction by A ((1 + sin)/2)^k
// (Skjermo 2007, equation 14, errata E23 to E27).
vec2 windForce(vec2 xy) {
  vec2 force = vec2(0.0);
  for (int i = 0; i < windCount; i++) {
    vec4 wave = windWaves[i];
    float s = sinTurns(windPhases[i].x * dot(wave.xy, xy) - windPhases[i].y);
    force += wave.xy * (wave.z * power(0.5 + 0.5 * s, wave.w));
  }
  return force;
}

// Force without peaks, A sin: the wind pulls as much as it pushes; for teaching (Skjermo 2007, equation 13).
vec2 linearWindForce(vec2 xy) {
  vec2 force = vec2(0.0);
  for (int i = 0; i < windCount; i++) {
    vec4 wave = windWaves[i];
    force += wave.xy * (wave.z * sinTurns(windPhases[i].x * dot(wave.xy, xy) - windPhases[i].y));
  }
  return force;
}
#endif
