#include /debug/check.glsl
#include /forest/card-texel.glsl
#include /leaf/texel.glsl
// Inputs: a texel of a card | a texel of a leaf, each as the halves of its four words, the lower first, which floats hold exactly.
uvec4 words(int layer) {
  uvec4 first = uvec4(given(layer));
  uvec4 second = uvec4(given(layer + 1));
  return uvec4(first.xz | (first.yw << 16u), second.xz | (second.yw << 16u));
}

void main() {
  CardTexel card = cardTexel(words(0));
  out0 = vec4(float(card.piece) + (card.odd ? 0.5 : 0.0), float(card.tree), card.v, card.phase);
  out1 = vec4(card.offset, card.radius);
  uvec4 bits = words(2);
  LeafTexel leaf = leafTexel(bits);
  out2 = vec4(float(leaf.piece) + (leaf.odd ? 0.5 : 0.0), float(card.picture) + 10.0 * float(leafTree(bits)), leaf.v, leaf.phase);
  out3 = leaf.orientation;
}
