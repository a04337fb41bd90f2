#ifndef FOREST_CARD_TEXEL
#define FOREST_CARD_TEXEL
// What the texture of a middle tree's cards says of one. Twin: src/core/pack/card-texel.ts

struct CardTexel {
  int piece;
  // Is the depth of the piece odd?
  bool odd;
  // Index of the tree in its grove.
  int tree;
  // Bezier parameter on the piece.
  float v;
  float phase;
  // In the piece's section frame at v, metres.
  vec3 offset;
  // Half of its side, metres.
  float radius;
  int picture;
};

// The card whose texel is `bits`: piece and parity (in a grove its tree, too) | v, phase | offset x, y | z, radius with picture.
CardTexel cardTexel(uvec4 bits) {
  vec2 place = unpackUnorm2x16(bits.y);
  vec2 xy = unpackHalf2x16(bits.z);
  vec2 zr = unpackHalf2x16(bits.w & 0xfffcffffu);
#ifdef GROVE
  int piece = int(bits.x & 0xfffffu);
  int tree = int((bits.x >> 20u) & 0x7ffu);
#else
  int piece = int(bits.x & 0x7fffffffu);
  int tree = 0;
#endif
  return CardTexel(
    piece, (bits.x >> 31u) == 1u, tree, place.x, place.y, vec3(xy, zr.x), zr.y, int((bits.w >> 16u) & 3u)
  );
}
#endif
