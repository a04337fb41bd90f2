#ifndef BRANCH_PART
#define BRANCH_PART
// How much of a piece is drawn of which only the first places of the draw order are.

// Places, the one at the border as a fraction | parts that a whole stem is cut into | bands of the grid
uniform vec3 branchPart;

// Where the vertex stands whose grid says v, 0..1. A piece takes its share of the stem's parts: rows beyond fall together at its end,
// and at the border all fall together at the cut. span: z0 | z1. Twin: partsOfPiece of src/core/lod/draw-counts.ts
float partOf(float v, int place, vec2 span) {
  vec2 marks = floor(branchPart.y * span + 0.5);
  return min(min(1.0, v * branchPart.z / max(1.0, marks.y - marks.x)), clamp(branchPart.x - float(place), 0.0, 1.0));
}
#endif
