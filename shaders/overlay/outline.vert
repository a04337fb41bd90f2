// The outline of a stem: a ribbon that faces the eye before each of its pieces and stands out at both sides, in the pose of the moment.
// Tree space. position: v along the piece | side -1..1. piece: number | 1 where its depth is odd | radius at its start | at its end.
#include /branch/section.glsl
#include /overlay/screen.glsl

in vec4 piece;

// Across in pixels | half the width of the stem there | half that of the ribbon.
out vec3 vMark;

// Pixels from the bark to the ribbon's edge.
const float BRIM = 5.0;

void main() {
  Pose pose = readPose(int(piece.x), piece.y > 0.5);
  Section here = sectionAt(pose, position.x);
  float radius = mix(piece.z, piece.w, position.x);
  vec4 seen = modelViewMatrix * vec4(here.centre, 1.0);
  // Before the bark, not in it.
  seen.xyz *= 1.0 - min(1.6 * radius / max(length(seen.xyz), 1e-3), 0.5);
  vec4 a = projectionMatrix * seen;
  vec4 b = projectionMatrix * (seen + modelViewMatrix * vec4(here.along * (0.2 * here.speed), 0.0));
  vec2 way = screenWay(a, b);
  float stem = max(1.05 * radius * pixelsPerMetre(a), 0.8);
  float half_ = stem + BRIM;
  vMark = vec3(position.y * half_, stem, half_);
  gl_Position = movedBy(a, vec2(-way.y, way.x) * vMark.x);
}
