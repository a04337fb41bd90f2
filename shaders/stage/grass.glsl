// Tufts of grass on the ground: they stand in the ground's own light, so they never read as things apart from it.
// position: root x | height of the corner | root z, roots in a square of side 2. normal.xy: offset of the corner, normal.z: tone.
out vec3 vGround;
out vec2 vBlade;

// Middle of the square before the eye (x, z), half its side, size of the blades as a part of their own; metres.
uniform vec4 grassSquare;
// As the ground has it: z is the radius of the trunk's foot.
uniform vec4 groundReach;

// A blade keeps its place on the ground: the square repeats over the whole meadow, and the copy nearest to its middle is drawn.
vec3 grassPoint() {
  float side = 2.0 * grassSquare.z;
  vec2 off = position.xz * grassSquare.z - grassSquare.xy;
  off -= side * floor(off / side + 0.5);
  float grown = grassSquare.w * (1.0 - smoothstep(0.55, 1.0, length(off) / grassSquare.z));
  vec2 root = grassSquare.xy + off;
  // Little grows in the shade of the trunk.
  grown *= mix(0.6, 1.0, smoothstep(groundReach.z, groundReach.z * 3.0, length(root)));
  return vec3(root.x + normal.x * grown, position.y * grown, root.y + normal.y * grown);
}
