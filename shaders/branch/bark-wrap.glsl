// Where the tile of bark lies on a stem. The same on meshes: src/core/look/bark-wrap.ts
// barkTile: its side in metres | 1 where its steps along the stem keep their length | ribs that it holds around, 0 for any | texels along a side.
uniform vec4 barkTile;

// Whole tiles fit around the stem's base, so that the pattern closes.
float barkRepeats(float baseRadius) {
  // One strip of the tile to each rib of the stem: both ends of a strip are alike, so any number of them closes.
  if (barkTile.z > 0.0 && stemShape[0].w > 0.0) return stemShape[0].z / barkTile.z;
  return max(1.0, floor(6.2831853 * baseRadius / barkTile.x + 0.5));
}

#ifdef BARK_OLD
// Metres along the stem, stretched where it is thicker than at its base and squeezed where it is thinner, as the pattern is around it.
float barkAlong(BranchVertex b) {
  float taper = stemShape[0].x;
  float share = max(taper < 1.0 ? taper : 2.0 - taper, 0.01);
  float left = 1.0 - share * b.z;
  float run = (max(0.2 - left, 0.0) * 5.0 - log(max(left, 0.2))) / share;
#ifdef FLARED
  float flare = stemShape[0].y;
  run += 0.027143 * log((1.0 + flare * exp2(-53.150850 * b.z)) / (1.0 + flare));
#endif
  return b.stemLength * run;
}
#endif

// Place on the tile, in tiles. turns: the angle around the stem.
vec2 barkWrap(BranchVertex b, float turns) {
  float repeats = barkRepeats(b.baseRadius);
  if (barkTile.z > 0.0 && stemShape[0].w > 0.0) {
    float strip = 1.0 / barkTile.z;
    return vec2(turns * repeats + strip * (floor(b.phase / strip) + 0.25), b.along / barkTile.x + b.phase * 7.0);
  }
  float u = turns * repeats + b.phase;
  if (barkTile.y > 0.5) return vec2(u, b.along / barkTile.x + b.phase * 7.0);
  float tile = max(6.2831853 * b.baseRadius / repeats, 0.12 * barkTile.x);
#ifdef BARK_OLD
  return vec2(u, barkAlong(b) / tile + b.phase * 7.0);
#else
  return vec2(u, b.along / tile + b.phase * 7.0);
#endif
}
