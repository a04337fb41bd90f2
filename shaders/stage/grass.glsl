// Tufts of grass on the ground: they stand in the ground's own light, so they never read as things apart from it.
// position: root x | height of the corner | root z, in units of the reach. normal.xy: offset of the corner, normal.z: tone.
out vec3 vGround;
out vec2 vBlade;

uniform float grassScale;

vec3 grassPoint() {
  return vec3(position.x * grassScale + normal.x, position.y, position.z * grassScale + normal.y);
}
