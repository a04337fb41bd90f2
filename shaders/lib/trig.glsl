#ifndef LIB_TRIG
#define LIB_TRIG
// Sine and cosine of turns, and powers, that agree with TypeScript to a few ulp: the built-in sine of software GL is off
// by 2e-4, and GLSL leaves pow undefined at 0. Twin: src/core/math/trig.ts

// Sine of a quarter turn or less (y in -0.25..0.25 turns): odd minimax polynomial of six terms, within 2e-7.
float sineOfQuarter(float y) {
  float s = y * y;
  float tail = 41.99998989 + s * -14.33702507;
  return y * (6.283185306 + s * (-41.34170193 + s * (81.60520943 + s * (-76.70366783 + s * tail))));
}

// Sine of an angle in turns, any size.
float sinTurns(float x) {
  float r = x - floor(x + 0.5);
  float a = abs(r);
  float s = sineOfQuarter(min(a, 0.5 - a));
  return r < 0.0 ? -s : s;
}

// Cosine of an angle in turns, any size.
float cosTurns(float x) {
  return sineOfQuarter(0.25 - abs(x - floor(x + 0.5)));
}

// x^k for x >= 0 and k > 0, 0 at 0.
float power(float x, float k) {
  return x > 0.0 ? exp2(k * log2(x)) : 0.0;
}

// Angle in radians between two unit vectors whose tips are `chord` apart (0..2), within 0.1 % up to 120 degrees.
float angleOfChord(float chord) {
  float s = chord * chord;
  return chord * (0.99933582 + s * (0.04752513 + s * (-0.00302809 + s * 0.00349376)));
}
#endif
