// What the bark needs besides the shape: texture coordinates that run on along a stem, and how sheltered the point is.
// bark.xy: texture; z: 1 on a thin twig, 0 on old wood; w: light of the sky that reaches the point, 0..1.
out vec4 vBark;
// Direction of growing theta in view space: with the normal it spans the surface that the relief is laid on.
out vec3 vAround;

// Side of a tile in metres.
uniform float barkTile;

// Whole tiles fit around the stem's base, so that the pattern closes; the same length of tile holds along it.
void barkVertex(BranchVertex b, float turns, float sky) {
  float around = 6.2831853 * b.baseRadius;
  float repeats = max(1.0, floor(around / barkTile + 0.5));
  float tile = max(around / repeats, 0.12 * barkTile);
  vBark.xy = vec2(turns * repeats + b.phase, b.along / tile + b.phase * 7.0);
  vBark.z = 1.0 - smoothstep(0.006, 0.035, b.radius);
  // The corner between a branch and its parent sees little of the sky.
  float joint = b.parentRadius > 0.0 ? smoothstep(0.6, 1.0, b.along / (b.parentRadius + 2.5 * b.radius)) : 1.0;
  vBark.w = sky * mix(0.6, 1.0, joint);
}
