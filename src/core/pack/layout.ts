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
  /** axis of the parent in the piece's base frame: along L | T | S, all 0 but in the first piece of a branch | index of the tree in its grove, 0 in a tree that stands alone */
  JOINT: 2,
} as const;

/**
 * Read by the leaf shader; RGBA32UI, 16 bytes a leaf, since leaves outnumber everything else; index = place in the draw
 * order, any prefix of it spread evenly over the crown. `leaf-texel.ts` writes and reads it.
 */
export const LEAF_LAYERS = {
  /** piece, and the top bit where its depth is odd; in a grove the tree's index from bit 20 on | v, phase in turns: 16 bits each | rotation x, y | z, w: 16 bits each */
  LEAF: 0,
} as const;

/** Written by the wind pass, one target each; index = piece. */
export const POSE_TARGETS = {
  /** P0.xyz | O.x */ P0: 0,
  /** P1.xyz | O.y */ P1: 1,
  /** P2.xyz | O.z */ P2: 2,
  /** P3.xyz | stir: how hard the leaves there are shaken, in metres of force */ P3: 3,
} as const;

/** Read by everything that draws a grove; index = tree of the grove. Grove space: metres, z up. */
export const TREE_LAYERS = {
  /** where it stands x | y | z | height, metres */
  PLACE: 0,
  /** centre of the crown x | y | z | length of its leaves, in those of the grove */
  CROWN: 1,
  /** radii of the crown along the tree's own axes x | y | z | 0 */
  RADII: 2,
  /** cosine | sine of the angle that it is turned by, from x to y | part of it that has come | part that a nearer class has taken over where it may, 0..1 */
  TURN: 3,
} as const;

/**
 * Read by the passes of the bend model `spring`; index = piece, same width and height as the pieces. Made anew from the mechanics of
 * a tree and the settings of a wind, by `springTexels`.
 */
export const SPRING_LAYERS = {
  /** rotation of the base frame at rest in tree space: x | y | z | w; its columns are L, T and S */
  FRAME: 0,
  /** one step of the oscillator less the identity: b11 | b12, s | b21, 1/s | b22 */
  STEP: 1,
  /** lever, s^2/m: bend that an acceleration of the base of 1 m/s^2 is worth | reach, m: how far a bend of 1 moves the piece's end | natural angular frequency, rad/s | 0 */
  LOAD: 2,
} as const;

/** Written by the pass of the springs, one target each; index = piece. Tree space, at whole steps. */
export const STATE_TARGETS = {
  /** bend along T | along S (of the frame at rest) | their velocities, 1/s */ Q: 0,
  /** acceleration of the piece's base, m/s^2 (3) | force of the wind, metres */ BASE: 1,
  /** acceleration of the piece's end, m/s^2 (3) | bend along L: the pull of the wind along the branch, which does not swing */ END: 2,
} as const;

/** Read by the pose where the bend model is `sway`; index = piece, same width and height as the pieces. */
export const SWAY_LAYERS = {
  /** bend for a swing of 1 of the 2nd edge | of the 3rd edge | frequency in 4096ths of a hertz, a whole number | 0.7 times that, whole */
  GAIN: 0,
  /** phase in turns of the swing along T | along S | 0 | 0 */
  OFFSET: 1,
} as const;

/** What a piece's stem is as a spring: `PackedTree.mechanics` has this many numbers a piece, of which the GPU reads none. */
export const MECHANICS = {
  /** Part [z0, z1] of its stem that the piece covers. */
  Z0: 0,
  Z1: 1,
  /** Of the stem, metres. */
  LENGTH: 2,
  /** Of the stem at its base, metres. */
  RADIUS: 3,
  /** Natural angular frequency of the stem with all that grows on it, rad/s. */
  OMEGA: 4,
  LEVEL: 5,
  /** A random number of the stem's own, [0, 1): pieces of a stem share it, no two stems do. */
  PHASE: 6,
  /** What the bends of the stem's level are multiplied by. */
  FLEXIBILITY: 7,
  /** What the damping ratio of a wind is multiplied by. */
  DAMPING: 8,
} as const;

/** Numbers a piece in `PackedTree.mechanics`. */
export const MECHANICS_SIZE = 9;

/** Numbers a texel. */
export const TEXEL = 4;
