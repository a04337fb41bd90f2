#ifndef LEAF_TEXEL
#define LEAF_TEXEL
// What the texture of the leaves says of one. Twin: src/core/pack/leaf-texel.ts

struct LeafTexel {
  int piece;
  // Is the depth of the piece odd?
  bool odd;
  // Bezier parameter on the piece.
  float v;
  // Turns.
  float phase;
  // Rotation in the piece's section frame at v.
  vec4 orientation;
};

// The tree that a leaf of a grove belongs to. Twin: src/core/pack/leaf-texel.ts (groveLeaf)
int leafTree(uvec4 bits) {
  return int((bits.x >> 20u) & 0x7ffu);
}

// The leaf whose texel is `bits`: piece and parity | v, phase | rotation x, y | z, w.
LeafTexel leafTexel(uvec4 bits) {
  vec2 place = unpackUnorm2x16(bits.y);
#ifdef GROVE
  int piece = int(bits.x & 0xfffffu);
#else
  int piece = int(bits.x & 0x7fffffffu);
#endif
  return LeafTexel(
    piece, (bits.x >> 31u) == 1u, place.x, place.y,
    vec4(unpackSnorm2x16(bits.z), unpackSnorm2x16(bits.w))
  );
}
#endif
