// Tufts of grass on the ground: they stand in the ground's own light, so they never read as things apart from it.
// position: root x | height of the corner | root z, roots in a square of side 2. normal.xy: offset of the corner, normal.z: tone.
out vec3 vGround;
out vec2 vBlade;

// Middle of the square before the eye (x, z), metres, and log2 of half its side.
uniform vec3 grassSquare;
// As the ground has it: z is the radius of the trunk's foot.
uniform vec4 groundReach;

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
  // Far blades are larger: they stand for the many that are not drawn.
  grown *= clamp(sqrt(reach / 6.0), 0.75, 1.6);
  return vec3(root.x + normal.x * grown, position.y * grown, root.y + normal.y * grown);
}
