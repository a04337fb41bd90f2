/**
 * The texel layouts: what the GPU reads, stated once. `layoutGlsl` turns this table into the constants that the shaders use.
 *
 * All textures but that of the leaves are RGBA32F. A piece, a branch or a leaf is one texel in each layer of its texture
 * array, at (index & (width - 1), index >> log2 width); width is a power of two.
 */

/** Read by the wind pass; index = piece, sorted by depth and then by parent. */
export const PIECE_LAYERS = {
  /** parent piece (-1: a root, which stands where its last pose stood) | v on the parent | bend weight of P2 | bend weight of P3 (both times the level's flexibility) */
  ATTACH: 0,
  /** rotation of the base frame in the parent's section frame: x | y | z | w */
  ORIENT: 1,
  /** p2.x | p2.y | p2.z | p1.x, metres in the base frame */
  HANDLE: 2,
  /** p3.x | p3.y | p3.z | arc length at rest, metres */
  END: 3,
  /** tip of the stem at rest x | y | z, where the wind is felt | a third of the stem's length */
  TIP: 4,
} as const;

/** Read by the branch deformer; index = place in the draw order, sorted by level and spread evenly within it. */
export const BRANCH_LAYERS = {
  /** piece | z0 | z1 | base radius of the stem in metres */
  SPAN: 0,
  /** length of the stem in metres | phase of the bark in turns | depth of the piece | radius of the parent where it starts */
  STEM: 1,
} as const;

/**
 * Read by the leaf shader; RGBA32UI, 16 bytes a leaf, since leaves outnumber everything else; index = place in the draw
 * order, any prefix of it spread evenly over the crown. `leaf-texel.ts` writes and reads it.
 */
export const LEAF_LAYERS = {
  /** piece, and the top bit where its depth is odd | v, phase in turns: 16 bits each | rotation x, y | z, w: 16 bits each */
  LEAF: 0,
} as const;

/** Written by the wind pass, one target each; index = piece. */
export const POSE_TARGETS = {
  /** P0.xyz | O.x */ P0: 0,
  /** P1.xyz | O.y */ P1: 1,
  /** P2.xyz | O.z */ P2: 2,
  /** P3.xyz | angle of the piece's bend in radians */ P3: 3,
} as const;

/** Numbers a texel. */
export const TEXEL = 4;
