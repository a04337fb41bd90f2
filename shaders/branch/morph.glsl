#ifndef BRANCH_MORPH
#define BRANCH_MORPH
// A grid becomes the coarser one that follows it before it is replaced by it: see src/view/grid-morph.ts.

// How far it has, 0..1 | its bands | those of the coarser one, not more | its sectors where that is a ribbon, else 0
uniform vec4 gridMorph;

// Rows gather in those of the coarser grid.
float morphedRow(float v) {
  float coarse = floor(v * gridMorph.z + 0.5) / gridMorph.z;
  return mix(v, coarse, gridMorph.x);
}

// Columns sink into its flat sides; chord: how far from the axis those are, as a part of the radius.
float morphedRadius(float chord) {
  return mix(1.0, chord, gridMorph.x);
}
#endif
