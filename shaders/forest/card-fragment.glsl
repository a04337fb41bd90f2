// Colour, normal and light of a clump, from its picture.
#include /forest/card-read.glsl
#include /forest/laid.glsl

// To the right, up and to the eye, view space.
flat in mat3 vCardFacing;
// Normal of the crown there, view space | light of the sky.
in vec4 vCardCrown;
in float vCardLaid;

uniform highp sampler2DArray cardShapes;
// How far normals turn from the leaves' own to the crown's, 0..1.
uniform float crownRounding;
// Light that leaves let through.
uniform vec3 cardThrough;
uniform vec4 levelTint;

vec4 cardColour() {
  return textureLod(cardColours, cardPlace(), cardLod());
}

vec3 cardNormal() {
  vec2 xy = 2.0 * textureLod(cardShapes, cardPlace(), cardLod()).xy - 1.0;
  // A picture that is shown as in a mirror is lit so, too.
  if (vCard.w < 0.5) xy.x = -xy.x;
  vec3 own = vCardFacing * vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
  return normalize(mix(own, vCardCrown.xyz, crownRounding) + 1e-4);
}
