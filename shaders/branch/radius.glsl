#ifndef BRANCH_RADIUS
#define BRANCH_RADIUS
#include /lib/trig.glsl
// How thick a stem is at z in 0..1 of its length: metres, slopes by z. Twin: src/core/deform/radius.ts

// Shape of the stems of a level; meaning and ranges: src/core/deform/radius.ts
struct Shape {
  float taper;
  float flare;
  float lobes;
  float lobeDepth;
  float lobeFade;
  float bulges;
  float bulgeDepth;
};

// Radius and slope without flare for taper 0..3: cylinder, cone, rounded end, chain of spheres (Weber & Penn 1995, 4.4).
// Finite everywhere; at the pole of a rounded end the slope stops at a thousand lengths of the stem.
vec2 taperRadius(float z, float taper, float radius, float stemLength) {
  if (radius <= 0.0) return vec2(0.0);
  float share = taper < 1.0 ? taper : max(2.0 - taper, 0.0);
  float cone = radius * (1.0 - share * z);
  float coneSlope = -radius * share;
  if (taper < 1.0) return vec2(cone, coneSlope);
  float left = (1.0 - z) * stemLength;
  float height = left;
  float heightSlope = -stemLength;
  float depth = 1.0;
  if (taper >= 2.0) {
    if (left >= cone) depth = min(taper, 3.0) - 2.0;
    float d = left - 2.0 * cone * floor(left / (2.0 * cone) + 0.5);
    height = abs(d);
    if (d < 0.0) heightSlope = stemLength;
  } else if (height >= cone) {
    return vec2(cone, coneSlope);
  }
  float round_ = sqrt(max(cone * cone - (height - cone) * (height - cone), 0.0));
  float rise = coneSlope * height + (cone - height) * heightSlope;
  float roundSlope = rise / max(round_, 1e-6 * radius);
  float most = 1000.0 * stemLength;
  return vec2(cone + depth * (round_ - cone), clamp(coneSlope + depth * (roundSlope - coneSlope), -most, most));
}

// Skjermo's taper r (1 - z^t) and its slope; t <= 0 asks for a cylinder (Skjermo 2006, equations 2 and 10, erratum E1).
vec2 powerTaper(float z, float radius, float t) {
  if (t <= 0.0) return vec2(radius, 0.0);
  float slope = -radius * t * (t == 1.0 ? 1.0 : power(t < 1.0 ? max(z, 1e-4) : z, t - 1.0));
  return vec2(radius * (1.0 - power(z, t)), slope);
}

// Factor of the flare, (f/100) 100^(1-8z) + 1, and its slope (Skjermo 2006, equations 3 and 10, erratum E2).
vec2 flare(float z, float f) {
  float e = f / 100.0 * exp2(6.643856189774724 * (1.0 - 8.0 * z));
  return vec2(e + 1.0, -36.841361487904736 * e);
}

// Weber & Penn's flare: as above less f/100, and exactly 1 from z = 1/8, with a crease there (4.4).
vec2 clampedFlare(float z, float f) {
  float e = f / 100.0 * exp2(6.643856189774724 * max(1.0 - 8.0 * z, 0.0));
  return vec2(e + 1.0 - f / 100.0, z < 0.125 ? -36.841361487904736 * e : 0.0);
}

// Factor of n bulges of depth d < 1 along the stem, and its slope (Skjermo 2006, equations 4 and 10).
vec2 bulges(float z, float n, float d) {
  return vec2(1.0 + d * sinTurns(n * z), 6.283185307179586 * n * d * cosTurns(n * z));
}

// Factor of n lobes of depth d < 1 at an angle in turns, its derivative by z and by the angle in radians
// (Skjermo 2006, equations 5, 10 and 11, errata E3 and E4).
vec3 lobes(float z, float turns, float n, float d, float fade) {
  float s = d * sinTurns(n * turns);
  float f = 1.0 - z * fade;
  return vec3(1.0 + s * f, -fade * s, d * n * cosTurns(n * turns) * f);
}

// Radius of a stem at z and at an angle in turns (0 on the side of T), its slope by z, and q = (d radius/d angle)/radius,
// finite at a tip too. A piece multiplies the slope by its share z1 - z0 (Skjermo 2006, equation 6).
vec3 stemRadius(Shape shape, float radius, float stemLength, float z, float turns) {
  vec2 taper = taperRadius(z, shape.taper, radius, stemLength);
  vec2 widening = flare(z, shape.flare);
  vec2 b = bulges(z, shape.bulges, shape.bulgeDepth);
  vec3 l = lobes(z, turns, shape.lobes, shape.lobeDepth, shape.lobeFade);
  float stem = taper.x * widening.x;
  float stemSlope = taper.y * widening.x + taper.x * widening.y;
  float relief = b.x * l.x;
  float reliefSlope = b.y * l.x + b.x * l.y;
  return vec3(stem * relief, stemSlope * relief + stem * reliefSlope, l.z / l.x);
}
#endif
