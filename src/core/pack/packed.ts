/** A texture array of four-part texels, as `layout.ts` describes its layers. */
export interface TexelArray<Data extends Float32Array | Uint32Array = Float32Array> {
  /** Power of two. */
  readonly width: number;
  readonly height: number;
  readonly layers: number;
  /** layers * height * width * 4 numbers, layer by layer, row by row. */
  readonly data: Data;
}

/** A range of the draw order. */
export interface DrawRange {
  readonly start: number;
  readonly count: number;
}

/** All that the GPU needs of a tree. Plain arrays: a worker hands it over without copying. */
export interface PackedTree {
  readonly pieceCount: number;
  readonly leafCount: number;
  /** First piece of each depth; the last entry is the number of pieces. */
  readonly depthStart: Uint32Array;
  /** Layers of PIECE_LAYERS. */
  readonly pieces: TexelArray;
  /** Rest pose, layers of POSE_TARGETS, same width and height as `pieces`. */
  readonly restPose: TexelArray;
  /** Layers of BRANCH_LAYERS. */
  readonly branches: TexelArray;
  /** Layers of LEAF_LAYERS. */
  readonly leaves: TexelArray<Uint32Array>;
  /** What the stems are as springs: MECHANICS_SIZE numbers a piece, laid out as MECHANICS says. The GPU reads what is made of them. */
  readonly mechanics: Float32Array;
  /** `leaves` holds cards of clumps (card-texel.ts) in place of leaves: a tree of a middle distance. */
  readonly cards?: boolean;
  /** Length of a blade in metres, the same for all leaves of a tree. */
  readonly leafLength: number;
  /** Part of the branch order that each level holds. */
  readonly levels: readonly DrawRange[];
  /** Box around the tree at rest: min x, y, z, max x, y, z in metres, z-up. */
  readonly bounds: Float32Array;
  /** Centroid of the leaves (or of the pieces where there are none) and radii of the crown about it, for shading. */
  readonly crown: Float32Array;
}
