/** Where a tree stands in the world and how it is turned: metres, and radians from x to y. */
export interface Placement {
  x: number;
  y: number;
  yaw: number;
  /** Metres from there to the farthest of its twigs, along the ground; 40 where it is not known. */
  reach?: number;
}

/** The reach of a tree that does not tell its own. */
export const TREE_REACH = 40;

/** A tree at the world's origin, its axes the world's. */
export const ORIGIN: Readonly<Placement> = { x: 0, y: 0, yaw: 0 };
