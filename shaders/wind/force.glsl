#ifndef WIND_FORCE
#define WIND_FORCE
#include /lib/trig.glsl
// force: what the wind does at a place. Twin: src/core/wind/force.ts (wavesAt fills the uniforms)

// Waves that are summed: 4, the usual number, or 8 while one wind fades into another. Slots not in use have no peak.
#ifndef WIND_WAVES
#define WIND_WAVES 8
#endif

// Direction x, y (unit, tree space), peak in metres, sharpness k.
uniform vec4 windWaves[WIND_WAVES];
// Turns a metre, phase in turns: the sine's argument is x * (direction . position) - y.
uniform vec2 windPhases[WIND_WAVES];

// What one wave does at xy: metres along its direction, A ((1 + sin)/2)^k.
vec2 wavePush(vec4 wave, vec2 phase, vec2 xy) {
  float s = sinTurns(phase.x * dot(wave.xy, xy) - phase.y);
  return wave.xy * (wave.z * power(0.5 + 0.5 * s, wave.w));
}

// Force at xy in tree space: metres of displacement, horizontal. Each wave pushes along its direction by A ((1 + sin)/2)^k
// (Skjermo 2007, equation 14, errata E23 to E27). Written out: on software GL a loop takes a third of the whole wind pass.
vec2 windForce(vec2 xy) {
  vec2 force = wavePush(windWaves[0], windPhases[0], xy);
  force += wavePush(windWaves[1], windPhases[1], xy);
  force += wavePush(windWaves[2], windPhases[2], xy);
  force += wavePush(windWaves[3], windPhases[3], xy);
#if WIND_WAVES > 4
  force += wavePush(windWaves[4], windPhases[4], xy);
  force += wavePush(windWaves[5], windPhases[5], xy);
  force += wavePush(windWaves[6], windPhases[6], xy);
  force += wavePush(windWaves[7], windPhases[7], xy);
#endif
  return force;
}

// Force without peaks, A sin: the wind pulls as much as it pushes; for teaching (Skjermo 2007, equation 13).
vec2 linearWindForce(vec2 xy) {
  vec2 force = vec2(0.0);
  for (int i = 0; i < WIND_WAVES; i++) {
    vec4 wave = windWaves[i];
    force += wave.xy * (wave.z * sinTurns(windPhases[i].x * dot(wave.xy, xy) - windPhases[i].y));
  }
  return force;
}
#endif
