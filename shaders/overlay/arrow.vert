// One arrow of the force field: from the place where the force is felt, along it. Tree space, z up.
// position: part of the length from tail to tip | side -1..1 | 1 on the head. spot: where it stands, metres | 0..1, how soon it is left out.
#include /overlay/screen.glsl
#include /stage/field.glsl

in vec3 spot;

// Longest arrow in metres | force in metres that gives 63 % of it | height above the ground | radius of the field.
uniform vec4 arrowField;

// Part of the length | side | how hard it blows 0..1 | fading towards the edge of the field.
out vec4 vArrow;

// Pixels between rows on screen that leave room for all arrows: where one looks along the ground, fewer stand.
const float ROOM = 15.0;

void main() {
  vec2 force = fieldForce(spot.xy);
  float strength = length(force);
  float hard = 1.0 - exp(-strength / arrowField.y);
  float size = arrowField.x * hard;
  vec3 foot = vec3(spot.xy, arrowField.z);
  vec3 tip = foot + vec3(force * (size / max(strength, 1e-6)), 0.0);
  vec4 a = onScreen(foot);
  vec2 way = screenWay(a, onScreen(tip));
  float metre = pixelsPerMetre(a);
  // The head keeps its shape where arrows grow, and shrinks with those that are short.
  float head = min(0.17 * arrowField.x, 0.45 * size);
  float thick = max(0.016 * arrowField.x * metre, 0.8);
  float neck = 1.0 - head / max(size, 1e-6);
  float along = position.z > 0.5 ? mix(neck, 1.0, position.x) : position.x * neck;
  // The shaft grows from nothing at its tail.
  float wide = position.z > 0.5 ? max(0.3 * head * metre, 1.8 * thick) : thick * position.x;
  gl_Position = movedBy(onScreen(mix(foot, tip, along)), vec2(-way.y, way.x) * (position.y * wide));
  vec3 eye = (modelViewMatrix * vec4(foot, 1.0)).xyz;
  float steep = abs(dot(normalize(eye), normalize(mat3(modelViewMatrix)[2])));
  float room = arrowField.x * steep * metre / ROOM;
  float edge = 1.0 - smoothstep(0.55, 1.0, length(spot.xy) / arrowField.w);
  // Nothing hangs before the eye, and nothing is drawn that is too small to be an arrow.
  float near = smoothstep(0.6, 1.6, a.w / arrowField.x);
  vArrow = vec4(along, position.y, hard, edge * near * smoothstep(2.0, 6.0, size * metre) * smoothstep(spot.z - 0.1, spot.z, room));
}
