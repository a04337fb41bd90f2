#ifndef FOREST_LAID
#define FOREST_LAID
// A gust that runs through a forest: it lays crowns over, and their leaves show the paler side.

// How far a crown is laid over by a force against the mean of the wind, both in metres: 0..1.
float crownLaid(float force, float mean) {
  return smoothstep(0.7, 1.8, force / (mean + 0.1)) * min(1.0, 3.0 * force);
}

// Colour of leaves that are laid over so far.
vec3 laidColour(vec3 c, float laid) {
  float grey = dot(c, vec3(0.2126, 0.7152, 0.0722));
  return mix(c, vec3(grey), 0.15 * laid) * (1.0 + 0.34 * laid);
}
#endif
