// Tufts of grass on the ground: they stand in the ground's own light, so they never read as things apart from it.
// position: root x | height of the corner | root z, in units of the reach. normal.xy: offset of the corner, normal.z: tone.
out vec3 vGround;
out vec2 vBlade;

uniform float grassScale;
uniform vec2 grassLean;

vec3 grassPoint() {
  float bend = position.y * position.y * 9.0;
  vec2 offset = normal.xy + grassLean * bend * (0.6 + normal.z);
  return vec3(position.x * grassScale + offset.x, position.y, position.z * grassScale + offset.y);
}
