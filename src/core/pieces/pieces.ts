/**
 * The cubic Bezier pieces that the GPU moves, as a struct of arrays, sorted by depth and then by parent.
 *
 * The base frame of a piece is (L, T, S) = (direction, y of the stem's frame, L x T): right-handed, the handles of
 * Skjermo 2006. Its control points in that frame are p0 = 0, p1 = (p1x, 0, 0), p2, p3.
 */
export interface Pieces {
  readonly count: number;
  /** Deepest piece: 0 for a trunk's first, one more for a child or for the next piece of a chain. */
  readonly maxDepth: number;
  /** First piece of each depth; `maxDepth + 2` entries. */
  readonly depthStart: Uint32Array;
  readonly depth: Uint16Array;
  /** The stem that the piece is a part of. */
  readonly stem: Int32Array;
  readonly level: Uint8Array;
  /** The piece that this one is attached to, -1 for a trunk's first. */
  readonly parent: Int32Array;
  /** Bezier parameter of the attachment on the parent, 0..1; 1 for the next piece of a chain. */
  readonly v: Float32Array;
  /** Rotation (x, y, z, w) of the base frame in the parent's section frame (U, T^, S^) at v; in tree space for a root. */
  readonly orientation: Float32Array;
  /** Where a root stands, 3 a root piece in order of index; roots are the pieces of depth 0. */
  readonly rootPosition: Float32Array;
  /** Control points in the base frame: p1x, p2 (3), p3 (3); 7 a piece. */
  readonly local: Float32Array;
  /** Control points of the rest pose in tree space: P0, P1, P2, P3; 12 a piece. */
  readonly control: Float32Array;
  /** Orientation vector O = T of the base frame at rest; 3 a piece. */
  readonly orient: Float32Array;
  /** Arc length at rest in metres. */
  readonly arc: Float32Array;
  /** Part [z0, z1] of the stem's whole length that the piece covers; 2 a piece. */
  readonly span: Float32Array;
  /** First piece of each stem; a stem's pieces are a chain, `next` leads along it, -1 ends it. */
  readonly firstOfStem: Int32Array;
  readonly next: Int32Array;
  /**
   * Largest distance between a stem's nodes and its pieces, both from the same base, as a fraction of the length that it covers;
   * by level. (Placed, a stem stands off its nodes by as much again as its parent's curve does from the parent's.)
   */
  readonly deviation: Float32Array;
}

/** Where the leaves hang on the pieces; the order is that of `Leaves`. */
export interface LeafAttachments {
  readonly piece: Int32Array;
  /** Bezier parameter on the piece. */
  readonly v: Float32Array;
  /** Rotation (x, y, z, w) of the leaf in the piece's section frame (U, T^, S^) at v; 4 a leaf. */
  readonly orientation: Float32Array;
}
