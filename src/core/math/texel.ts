/** Column and row of element `index` in a texture whose width is 2^log2Width. Twin: shaders/lib/texel.glsl. */
export const texelOf = (index: number, log2Width: number): [number, number] => [
  index & ((1 << log2Width) - 1),
  index >> log2Width,
];
