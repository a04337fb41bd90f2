// What the bark needs besides the shape: texture coordinates that run on along a stem, and how sheltered the point is.
// bark.xy: texture; z: 1 on a thin twig, 0 on old wood; w: light of the sky that reaches the point, 0..1.
out vec4 vBark;
// Direction of growing theta in view space: with the normal it spans the surface that the relief is laid on.
out vec3 vAround;
#ifdef BARK_OLD
// xy: place on the tile of what grows on bark; z: how much moss likes it there; w: 1 at the ground, 0 some radii above it.
out vec4 vGrowth;
#endif

// Radius in metres at which a twig's bark has become old.
uniform float barkYoung;

#ifdef BARK_OLD
// Moss keeps to the foot, to the side that the sun does not dry, and to what lies flat.
const vec3 SHADED = vec3(-0.83, 0.5, 0.25);

vec4 barkGrowthAt(BranchVertex b, float turns) {
  float around = 6.2831853 * b.baseRadius;
  float repeats = max(1.0, floor(around / 0.7 + 0.5));
  float side = max(around / repeats, 0.3);
  vec3 n = b.surface.normal;
  float up = b.surface.position.z;
#ifdef GROVE
  up -= treeTexel(TREE_PLACE).z;
#endif
  float foot = 1.0 - smoothstep(0.0, 1.6, up);
  float shade = smoothstep(-0.45, 0.9, dot(n, SHADED));
  float flat_ = smoothstep(0.1, 0.9, n.z) * step(0.5, b.parentRadius * 1e6);
  float likes = 0.55 * shade + 0.5 * foot * (0.4 + 0.6 * shade) + 0.45 * flat_ - 0.03 * up;
  return vec4(turns * repeats + b.phase, b.along / side + b.phase * 5.0, likes, 1.0 - smoothstep(0.0, 5.0, up / b.baseRadius));
}
#endif

void barkVertex(BranchVertex b, float turns, float sky) {
  vBark.xy = barkWrap(b, turns);
  // The corner between a branch and its parent sees little of the sky, and its bark is as old as the parent's.
  float reach = b.along / (b.parentRadius + 2.5 * b.radius);
  float joint = b.parentRadius > 0.0 ? smoothstep(0.45, 1.0, reach) : 1.0;
  float age = b.parentRadius > 0.0 ? mix(b.parentRadius, b.radius, smoothstep(0.3, 1.1, reach)) : b.radius;
  vBark.z = 1.0 - smoothstep(0.17 * barkYoung, barkYoung, age);
  vBark.w = sky * mix(0.66, 1.0, joint);
#ifdef BARK_OLD
  vGrowth = barkGrowthAt(b, turns);
#endif
}
