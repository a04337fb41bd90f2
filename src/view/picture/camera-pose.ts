import type { Vector3 } from 'three';
import type { CameraPose } from '../../core/link/link.ts';

const DEGREE = Math.PI / 180;

/** Where a camera at `position` that looks at `target` stands, in the numbers of a link. */
export function poseOf(position: Vector3, target: Vector3): CameraPose {
  const x = position.x - target.x;
  const y = position.y - target.y;
  const z = position.z - target.z;
  const distance = Math.hypot(x, y, z);
  return {
    azimuth: (Math.atan2(x, z) / DEGREE + 360) % 360,
    elevation: distance > 0 ? Math.asin(Math.max(-1, Math.min(1, y / distance))) / DEGREE : 0,
    distance,
    target: [target.x, target.y, target.z],
  };
}

/** Sets `position` and `target` to where the numbers of a link say. */
export function placeOf(pose: CameraPose, position: Vector3, target: Vector3): void {
  const level = pose.distance * Math.cos(pose.elevation * DEGREE);
  const azimuth = pose.azimuth * DEGREE;
  target.set(...pose.target);
  position.set(
    target.x + level * Math.sin(azimuth),
    target.y + pose.distance * Math.sin(pose.elevation * DEGREE),
    target.z + level * Math.cos(azimuth),
  );
}
