#ifndef WIND_HEIGHTS
#define WIND_HEIGHTS
// How the wind grows with height. Twin: src/core/wind/profile.ts (fillProfile fills the uniform)

// 1/height | slope of the logarithm a doubling | exponent of the power law | weight of the logarithm, 0..1; the power law has the rest.
uniform vec4 windProfile;

// Factor on the wind z metres above the ground, 1 at the profile's height: w max(0, 1 + b log2 z/h) + (1 - w) (z/h)^a (Stull 1988, 9.7).
// At and below the ground log2 of 2^-40 of the height: nothing blows there.
float profileFactor(float z) {
  float l = log2(max(z * windProfile.x, 9.094947e-13));
  return windProfile.w * max(0.0, 1.0 + windProfile.y * l) + (1.0 - windProfile.w) * exp2(windProfile.z * l);
}
#endif
