#ifndef FOREST_OCTAHEDRAL
#define FOREST_OCTAHEDRAL
// The hemi-octahedral square of views around a tree. Twin: src/core/forest/octahedral.ts

// Where a unit vector (z up) lies on the square -1..1; below the horizon its nearest there.
vec2 hemiOctahedral(vec3 d) {
  float n = abs(d.x) + abs(d.y) + max(d.z, 0.0);
  return vec2(d.x + d.y, d.y - d.x) / n;
}

// The unit vector of a place on the square.
vec3 fromHemiOctahedral(vec2 e) {
  vec2 p = 0.5 * vec2(e.x - e.y, e.x + e.y);
  return normalize(vec3(p, 1.0 - abs(p.x) - abs(p.y)));
}

// Direction that a view of `views` by `views` is taken from.
vec3 viewDirection(vec2 cell, float views) {
  return fromHemiOctahedral(2.0 * cell / (views - 1.0) - 1.0);
}

// What a camera at d has to its right, above, and d itself, as columns.
mat3 viewFrame(vec3 d) {
  float level = length(d.xy);
  vec3 right = level > 1e-4 ? vec3(-d.y, d.x, 0.0) / level : vec3(0.0, 1.0, 0.0);
  return mat3(right, cross(d, right), d);
}

// The three views around d, the heaviest first: columns, row | weight.
mat3 nearestViews(vec3 d, float views) {
  vec2 place = (0.5 * hemiOctahedral(d) + 0.5) * (views - 1.0);
  vec2 cell = clamp(floor(place), 0.0, views - 2.0);
  vec2 f = place - cell;
  vec2 aside = f.x > f.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  vec3 a = vec3(cell, 1.0 - max(f.x, f.y));
  vec3 b = vec3(cell + aside, abs(f.x - f.y));
  vec3 c = vec3(cell + 1.0, min(f.x, f.y));
  if (b.z > a.z) { vec3 s = a; a = b; b = s; }
  if (c.z > a.z) { vec3 s = a; a = c; c = s; }
  return mat3(a, b, c);
}
#endif
