// Places one card on the branch that carries its clump: a quad that faces the eye, or in a shadow pass the light. Read by the standard,
// depth and distance materials alike. position: corner, -1..1 | copy within the bundle.
// Source: camera-facing quads of Malheiros & Walter 2011, section 4.
#include /branch/section.glsl
#include /lib/hash.glsl
#include /lib/trig.glsl
#include /forest/card-texel.glsl
#include /forest/laid.glsl
#ifdef GROVE
#include /forest/grove-tree.glsl
#endif

uniform highp usampler2DArray leaves;
uniform int leafLog2Width;
// Cards to draw, copies an instance.
uniform ivec2 cardRange;
// How much larger they are drawn | widest swing of a card in radians | time in sixteenths of a beat, wrapped to 0..1.
uniform vec3 cardSize;

struct CardVertex {
  vec3 position;
  vec3 centre;
  // To the right, up and to the eye, in the space of the positions.
  mat3 facing;
  vec2 corner;
  float picture;
  // 0..1, its own.
  float own;
  // Force of the wind that it feels, metres.
  float force;
};

CardVertex cardVertex() {
  int place = gl_InstanceID * cardRange.y + int(position.z);
  CardVertex nothing = CardVertex(vec3(0.0), vec3(0.0), mat3(1.0), vec2(0.0), 0.0, 0.0, 0.0);
#ifdef GROVE
  vShare = vec2(0.0);
#endif
  if (place >= cardRange.x) return nothing;
  uvec4 bits = texelFetch(leaves, ivec3(texelOf(place, leafLog2Width), LEAF_LEAF), 0);
  CardTexel card = cardTexel(bits);
#ifdef GROVE
  if (!enterTree(card.tree)) return nothing;
#endif
  Pose pose = readPose(card.piece, card.odd);
  Section section = sectionAt(pose, card.v);
  CardVertex result;
  result.centre = section.centre + mat3(section.along, section.t, section.s) * card.offset;
  mat3 view = mat3(modelViewMatrix);
  vec3 eye = projectionMatrix[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) * view : normalize(-(modelViewMatrix[3].xyz * view) - result.centre);
  // Upright, as its picture was taken; seen from above it keeps the turn that it has there.
  vec3 up = abs(eye.z) < 0.99 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
  vec3 right = normalize(cross(up, eye));
  result.facing = mat3(right, cross(eye, right), eye);
  result.own = hashUnit(hashPcg(uint(card.phase * 65535.0 + 0.5)));
  // A clump swings about its middle as its leaves would; half of them are shown as in a mirror, so that four pictures do.
  float hard = 1.0 - exp2(-8.0 * pose.stir);
  float beat = floor(5.0 + 6.0 * result.own);
  float swing = cardSize.y * hard * sinTurns(beat * cardSize.z + card.phase);
  vec2 corner = position.xy;
  vec2 turned = vec2(corner.x - swing * corner.y, corner.y + swing * corner.x);
  result.corner = vec2(result.own < 0.5 ? -corner.x : corner.x, corner.y);
  result.force = pose.stir;
  result.picture = float(card.picture);
  result.position = result.centre + mat2x3(right, result.facing[1]) * turned * (card.radius * cardSize.x);
  return result;
}
