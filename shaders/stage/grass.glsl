// Tufts of grass on the ground: they stand in the ground's own light, so they never read as things apart from it.
// position: root x | height of the corner | root z, roots in a square of side 2. normal.xy: offset of the corner, normal.z: tone.
#include /stage/field.glsl
#include /stage/sky.glsl

out vec3 vGround;
out vec3 vHaze;
// Height on the blade | tone | how far the wind has laid it over, 0..1 | 0, or 0..1 for the colour of a flower.
out vec4 vBlade;

// Middle of the square before the eye (x, z), metres, and log2 of half its side.
uniform vec3 grassSquare;
// As the ground has it: z is the radius of the trunk's foot.
uniform vec4 groundReach;
// Height of the grass as a multiple, share of the blades that bear a flower.
uniform vec2 grassGrowth;

#ifndef GRASS_ON_TERRAIN
// Height of the ground at a root; grown: how high a blade grows there. A terrain brings its own (shaders/forest/grass-ground.glsl).
float grassGround(vec2 root, float own, inout float grown) {
  return 0.0;
}
#endif

vec3 grassPoint() {
  // Sides are powers of two, so that no blade slides while the eye moves; each tuft goes to the next one at a moment of its
  // own, and is down while it does.
  float steps = grassSquare.z + fract(position.x * 43.7);
  float part = fract(steps);
  float reach = exp2(floor(steps));
  // A blade keeps its place on the ground: the square repeats over the whole meadow, and the copy nearest to its middle is drawn.
  vec2 off = position.xz * reach - grassSquare.xy;
  off -= 2.0 * reach * floor(off / (2.0 * reach) + 0.5);
  vec2 root = grassSquare.xy + off;
  float grown = smoothstep(0.0, 0.1, part) * (1.0 - smoothstep(0.9, 1.0, part));
  // It thins towards the edge of its square, where the next blade may be down already.
  grown *= 1.0 - smoothstep(0.25 + 0.55 * fract(position.z * 91.3), 1.0, length(off) / reach);
  // Little grows in the shade of the trunk.
  grown *= mix(0.6, 1.0, smoothstep(groundReach.z, groundReach.z * 3.0, length(root)));
  float ground = grassGround(root, fract(position.x * 71.3), grown);
  // Far blades are larger: they stand for the many that are not drawn.
  grown *= clamp(sqrt(reach / 6.0), 0.75, 1.6);
  // Grass is soft: a breeze lays it over by a third, a gale by two. Never flat: the next gust would find nothing to move. No two blades
  // are as stiff.
  vec2 force = fieldForce(vec2(root.x, -root.y));
  float strength = length(force);
  float lean = strength / (strength + 0.8 - 0.5 * normal.z);
  vec2 way = normalize(force + 1e-6);
  // Seen from near, as a fern is, blades and heads are as slender as they are.
  float slender = clamp(reach / 16.0, 0.4, 1.0);
  vec2 offset = normal.xy * (position.y > 0.0 ? 1.0 : slender);
  float high = position.y;
  float own = fract(position.x * 517.3 + position.z * 283.1);
  float flower = 0.0;
  if (own < grassGrowth.y * mix(0.2, 1.8, step(0.5, fract(dot(floor(root * 0.35), vec2(0.37, 0.73)) * 1.618)))) {
    // Its triangle stands on its tip: a head on a stalk too thin to see.
    flower = 0.05 + 0.95 * fract(own * 7919.0);
    high = high > 0.0 ? 0.2 - 0.04 * slender : 0.2;
    offset = high > 0.199 ? normalize(offset + 1e-5) * 0.016 * slender : vec2(0.0);
  }
  float up = high * grown * grassGrowth.x;
  float angle = 0.21 * lean;
  vec2 corner = offset * grown * (position.y > 0.0 ? 1.0 - 0.5 * lean : 1.0) + vec2(way.x, -way.y) * (up * sinTurns(angle));
  vBlade = vec4(position.y > 0.0 || flower > 0.0 ? 1.0 : 0.0, normal.z, lean, flower);
  return vec3(root.x + corner.x, ground + up * cosTurns(angle), root.y + corner.y);
}
