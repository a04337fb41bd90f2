#ifndef BRANCH_FLATTEN
#define BRANCH_FLATTEN
#include /branch/morph.glsl
// A tube before it is replaced by a ribbon: its corners sink into the plane that faces the eye, and what they show of its light is a ribbon's.
// toEye: from the axis to the eye, tree space; radial: from the axis to the corner; sectors: corners around the tube.
SurfacePoint flattened(SurfacePoint tube, Section section, vec3 toEye, vec3 radial, float radius, float sectors) {
  vec3 side = unitOr(cross(section.along, toEye), section.t);
  vec3 facing = cross(side, section.along);
  // The corner farthest to a side is not quite as far as a circle's edge; a ribbon is.
  float corner = atan(dot(side, section.s), dot(side, section.t)) * sectors / 6.2831853;
  float across = dot(radial, side) / cos((fract(corner + 0.5) - 0.5) * 6.2831853 / sectors);
  tube.position = mix(tube.position, section.centre + side * (radius * across), gridMorph.x);
  tube.normal = mix(tube.normal, 0.342 * facing + 0.94 * across * side, gridMorph.x);
  return tube;
}
#endif
