// Colour, normal and light of a clump, from its picture.
#include /forest/card-read.glsl
#include /forest/laid.glsl
#include /forest/dither.glsl

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

// Depths in a picture between which leaves go from lit to sheltered by those before them, and what light reaches the deepest.
const vec2 CARD_DEPTHS = vec2(0.36, 0.62);
const float CARD_DEEPEST = 0.6;
// Part of the alpha over which a texel is drawn in part: needles are thinner than texels.
const float SOFT_EDGE = 0.7;

vec4 cardColour() {
  vec4 colour = textureLod(cardColours, cardPlace(), cardLod());
  float deep = smoothstep(CARD_DEPTHS.x, CARD_DEPTHS.y, textureLod(cardShapes, cardPlace(), cardLod()).z);
  colour.rgb *= mix(1.0, CARD_DEEPEST, deep);
  return colour;
}

vec3 cardNormal() {
  vec2 xy = 2.0 * textureLod(cardShapes, cardPlace(), cardLod()).xy - 1.0;
  // A picture that is shown as in a mirror is lit so, too.
  if (vCard.w < 0.5) xy.x = -xy.x;
  vec3 own = vCardFacing * vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
  return normalize(mix(own, vCardCrown.xyz, crownRounding) + 1e-4);
}
