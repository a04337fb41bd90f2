import { type Box3, MathUtils, Vector3 } from 'three';

/** Where a camera stands and what it looks at; metres, y up. */
export interface Framing {
  readonly position: Vector3;
  readonly target: Vector3;
}

/** Height of the eye: that of a person on a meadow, or for a tall tree that of a rise in front of it; metres, and parts of the height, as least and most. */
const EYE = 1.6;
const RISE = 0.14;

/** Place of the horizon, and most of the picture that crown and foot may take, from the middle (0) to the edge (1). */
const HORIZON = -0.46;
const TOP = 0.84;
const SIDE = 0.84;
const FOOT = 0.86;

/** How far below the middle of the picture the middle of a tree may come, at most. */
const LOW = 0.06;

/**
 * The view of a whole tree from eye height: horizon a third up, air above the crown, both sides inside.
 *
 * `box` in metres with y up; `fov` vertical in degrees; `aspect` width over height of the window, whatever its shape.
 * `azimuth` in radians about the vertical, 0 from +z.
 */
export function frameTree(box: Box3, fov: number, aspect: number, azimuth: number): Framing {
  const half = Math.tan(MathUtils.degToRad(fov) / 2);
  const height = Math.max(box.max.y, 0.1);
  const eye = Math.min(Math.max(EYE, RISE * height), 0.2 * height);
  const centre = box.getCenter(new Vector3());
  const radius = Math.max(box.max.x - box.min.x, box.max.z - box.min.z, 0.1) / 2;
  // The view is tilted up so that the level of the eye falls on the horizon's place.
  const pitch = Math.atan(-HORIZON * half);
  const byHeight = (height - eye) / Math.tan(pitch + Math.atan(TOP * half));
  const byWidth = radius / (SIDE * half * aspect) + radius * 0.35;
  const byFoot = eye / Math.tan(Math.atan(FOOT * half) - pitch) + radius * 0.6;
  const distance = Math.max(byHeight + radius * 0.25, byWidth, byFoot);
  // A tree that a narrow window makes small stands in its middle, not at its foot.
  const middle = Math.atan((height / 2 - eye) / distance) + LOW * half;
  const target = new Vector3(centre.x, eye + distance * Math.tan(Math.min(pitch, middle)), centre.z);
  const position = new Vector3(centre.x + distance * Math.sin(azimuth), eye, centre.z + distance * Math.cos(azimuth));
  return { position, target };
}
