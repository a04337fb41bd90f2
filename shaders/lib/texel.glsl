#ifndef LIB_TEXEL
#define LIB_TEXEL
// Where element `index` lies in a texture whose width is 2^log2Width: row by row, as src/core/pack/layout.ts says.
// Twin: src/core/math/texel.ts
ivec2 texelOf(int index, int log2Width) {
  return ivec2(index & ((1 << log2Width) - 1), index >> log2Width);
}
#endif
