#ifndef WIND_FORCE
#define WIND_FORCE
#include /lib/trig.glsl
#include /wind/gust.glsl
#include /wind/profile.glsl
#include /wind/record.glsl
// force: what the wind does at a place. Twin: src/core/wind/force.ts (windStateAt and WindFader.at in fade.ts fill the uniforms;
// forceDefines in force-variant.ts says what a wind needs)

// Waves that are summed: 4, the paper's number, 8, or 16 while one wind fades into another. Slots not in use have no peak.
#ifndef WIND_WAVES
#define WIND_WAVES 16
#endif
// Whether gusts (8) blow, the wind depends on the height (1), a record plays (1).
#ifndef WIND_GUSTS
#define WIND_GUSTS 0
#endif
#ifndef WIND_PROFILE
#define WIND_PROFILE 0
#endif
#ifndef WIND_RECORD
#define WIND_RECORD 0
#endif

// Direction x, y (unit, tree axes), peak in metres, sharpness k.
uniform vec4 windWaves[WIND_WAVES];
// Turns a metre, phase in turns: the sine's argument is x * (direction . position) - y; the mean that is taken off a push of peak 1; 0.
uniform vec4 windPhases[WIND_WAVES];

// What one wave does at xy: metres along its direction, A (((1 + sin)/2)^k - mean) (Skjermo 2007, equation 14, errata E23 to E27).
vec2 wavePush(vec4 wave, vec4 phase, vec2 xy) {
  float s = sinTurns(phase.x * dot(wave.xy, xy) - phase.y);
  return wave.xy * (wave.z * (power(0.5 + 0.5 * s, wave.w) - phase.z));
}

// Force of the waves alone at xy in tree axes: metres of displacement, horizontal. Written out: on software GL a loop takes a third of
// the whole wind pass.
vec2 wavesForce(vec2 xy) {
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
#if WIND_WAVES > 8
  force += wavePush(windWaves[8], windPhases[8], xy);
  force += wavePush(windWaves[9], windPhases[9], xy);
  force += wavePush(windWaves[10], windPhases[10], xy);
  force += wavePush(windWaves[11], windPhases[11], xy);
  force += wavePush(windWaves[12], windPhases[12], xy);
  force += wavePush(windWaves[13], windPhases[13], xy);
  force += wavePush(windWaves[14], windPhases[14], xy);
  force += wavePush(windWaves[15], windPhases[15], xy);
#endif
  return force;
}

// Force of the wind at a place in tree space: metres of displacement, horizontal: waves, gusts and record, by the factor of the height.
vec2 windForce(vec3 place) {
  vec2 force = wavesForce(place.xy);
#if WIND_GUSTS > 0
  force += gustsForce(place.xy);
#endif
#if WIND_RECORD > 0
  force += recordForce(place.xy);
#endif
#if WIND_PROFILE > 0
  force *= profileFactor(place.z);
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
