import type { GrownPacked } from '../pack/grow-packed.ts';
import { type BarkMesh, meshBark } from './bark-mesh.ts';
import { type LeafPlacements, placeLeaves } from './leaf-placements.ts';
import { GRADES, type MeshGrade } from './mesh-detail.ts';
import { placeOrgans } from './organ-placements.ts';

/** A tree as triangles: its stems as one mesh, its leaves as one leaf and its places. Metres, tree space (z up). */
export interface TreeMesh extends BarkMesh {
  /** Null where the tree has no leaves, or none were asked for. `expandLeaves` makes triangles of them. */
  readonly leaves: LeafPlacements | null;
  /** What twigs bear besides, likewise. */
  readonly organs: LeafPlacements | null;
}

export interface TreeMeshOptions {
  readonly detail: MeshGrade;
  /** Levels of stems that are meshed, from the trunk on; with it the leaves on them. All by default. */
  readonly levels?: number;
  /** Are leaves wanted? True by default. */
  readonly leaves?: boolean;
  /** Leaves at most; all by default. */
  readonly mostLeaves?: number;
  /** A pose laid out as POSE_TARGETS, as `poseTree` makes it; the rest pose by default. Triangles are the same in every pose. */
  readonly pose?: Float32Array;
  /** Bands of every piece at least, on levels below `bentLevels`. */
  readonly leastBands?: number;
  readonly bentLevels?: number;
}

/**
 * The surface that is drawn, as triangles: the same on every machine for the same tree and options.
 *
 * Stems run without a crack from piece to piece and end closed; their base is open, inside the parent or the ground. Nothing has a zero
 * area, all triangles are counter-clockwise from outside. Source: the deformer's twins in core/deform.
 */
export function meshTree(grown: GrownPacked, options: TreeMeshOptions): TreeMesh {
  const rule = GRADES[options.detail];
  const { levels = Number.POSITIVE_INFINITY, pose, leastBands = 1, bentLevels = 0 } = options;
  const most = options.mostLeaves ?? Number.POSITIVE_INFINITY;
  const shared = { levels, ...(pose ? { pose } : {}) };
  const placing = { grain: rule.leaf, most, share: rule.leaves, ...shared };
  const wanted = options.leaves !== false;
  return {
    ...meshBark(grown, { grade: options.detail, leastBands, bentLevels, ...shared }),
    leaves: wanted ? placeLeaves(grown, placing) : null,
    organs: wanted ? placeOrgans(grown, placing) : null,
  };
}
