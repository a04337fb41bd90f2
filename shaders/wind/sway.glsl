#ifndef WIND_SWAY
#define WIND_SWAY
#include /lib/trig.glsl
// sway: every stem swings by two sines about its two axes, whatever blows (Weber & Penn 1995, 4.7). Turns, seconds.
// Twin: src/core/wind/sway.ts

// Amplitude of the sine | of the slower one | how hard leaves are shaken at a full swing, metres of force | 0.
uniform vec4 windSway;
// Whole seconds, 0 to 4095 | the rest of the time, 0 to 1.
uniform vec2 windClock;

// Phase in turns of a swing of k/4096 Hz, k whole: exact for as long as the wind blows, since only whole turns are dropped.
float swayPhase(float k, vec2 clock) {
  int whole = (int(k) * int(clock.x)) & 4095;
  return (float(whole) + k * clock.y) * (1.0 / 4096.0);
}

// The swing along T and S: a1 sin b + a2 sin 0.7 b with b = offset + turns. gain, offset: the texels of SWAY_LAYERS.
vec2 swaySwing(vec4 gain, vec4 offset, vec4 sway, vec2 clock) {
  float quick = swayPhase(gain.z, clock);
  float slow = swayPhase(gain.w, clock);
  return vec2(
    sway.x * sinTurns(quick + offset.x) + sway.y * sinTurns(slow + 0.7 * offset.x),
    sway.x * sinTurns(quick + offset.y) + sway.y * sinTurns(slow + 0.7 * offset.y)
  );
}

// How hard the leaves are shaken, metres of force.
float swayStir(vec2 swing, vec4 sway) {
  return sway.z * length(swing) / max(sway.x + sway.y, 1e-9);
}
#endif
