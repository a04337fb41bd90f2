#ifndef FOREST_CARD_READ
#define FOREST_CARD_READ
// Reads the picture of a clump. xy: place on it, -1..1; z: which; w: its own number.
in vec4 vCard;

uniform highp sampler2DArray cardColours;
// Layer of the atlas | pictures along its side | part of a picture's side that the clump fills | texels of a picture.
uniform vec4 cardPictures;

vec3 cardPlace() {
  vec2 cell = vec2(mod(vCard.z + 0.01, cardPictures.y), (vCard.z + 0.01) / cardPictures.y);
  return vec3((floor(cell) + 0.5 + 0.5 * cardPictures.z * vCard.xy) / cardPictures.y, cardPictures.x);
}

// Its level by how fast the place changes; nothing coarser than what keeps neighbours apart.
float cardLod() {
  vec2 d = fwidth(vCard.xy) * (0.5 * cardPictures.w);
  return clamp(log2(max(max(d.x, d.y), 1e-3)) - 0.5, 0.0, 4.0);
}
#endif
