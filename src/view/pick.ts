import { type Box3, type Ray, Vector3 } from 'three';
import { BRANCH_LAYERS, TEXEL } from '../core/pack/layout.ts';
import type { PackedTree } from '../core/pack/packed.ts';

/** Straight parts that a piece is taken as when it is picked. */
const PARTS = 4;

/** Slack in metres, so that a twig can be hit at all. */
const SLACK = 0.01;

const a = new Vector3();
const b = new Vector3();
const onRay = new Vector3();
const onPart = new Vector3();
const corner = [new Vector3(), new Vector3(), new Vector3(), new Vector3()] as const;

function bezier(u: number, out: Vector3): Vector3 {
  const w = 1 - u;
  return out
    .copy(corner[0])
    .multiplyScalar(w * w * w)
    .addScaledVector(corner[1], 3 * w * w * u)
    .addScaledVector(corner[2], 3 * w * u * u)
    .addScaledVector(corner[3], u * u * u);
}

/** Where a ray meets a branch, and which piece. */
export interface Picked {
  readonly point: Vector3;
  readonly piece: number;
}

/** How a ray picks. */
export interface Picking {
  /** Places of the draw order that count. */
  readonly places: number;
  /** Laid out as `PackedTree.restPose.data`; the rest pose by default. */
  readonly pose?: Float32Array;
  /** Where no branch is hit, how far beside the ray one may be, in metres a metre of distance; 0 by default. */
  readonly near?: number;
}

/**
 * Where a ray in tree space first meets a branch, or the branch that it passes closest by, or null.
 *
 * The pose of the moment lives on the GPU; one that is not at hand is seldom farther from its rest than the pointer is from it.
 */
export function pickBranch(
  tree: PackedTree,
  ray: Ray,
  { places, pose = tree.restPose.data, near = 0 }: Picking,
): Picked | null {
  const { branches, restPose } = tree;
  const plane = restPose.width * restPose.height * TEXEL;
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  // What is hit is rated by its distance, what is missed, after all that is hit, by how far beside the ray it is seen.
  let best = Number.POSITIVE_INFINITY;
  let hit = false;
  let found: Picked | null = null;
  for (let i = 0; i < places; i++) {
    const t = span + i * TEXEL;
    const piece = branches.data[t] as number;
    const z0 = branches.data[t + 1] as number;
    const z1 = branches.data[t + 2] as number;
    const base = branches.data[t + 3] as number;
    for (let k = 0; k < 4; k++) (corner[k] as Vector3).fromArray(pose, k * plane + piece * TEXEL);
    // A sphere around the control polygon's ends rules most pieces out.
    a.addVectors(corner[0], corner[3]).multiplyScalar(0.5);
    const slack = SLACK + near * a.distanceTo(ray.origin);
    const reach = Math.max(a.distanceTo(corner[0]), a.distanceTo(corner[1]), a.distanceTo(corner[2])) + base + slack;
    if (ray.distanceSqToPoint(a) > reach * reach) continue;
    bezier(0, a);
    for (let part = 1; part <= PARTS; part++) {
      bezier(part / PARTS, b);
      const radius = base * (1 - (z0 + ((z1 - z0) * (part - 0.5)) / PARTS)) + SLACK;
      const apart = ray.distanceSqToSegment(a, b, onRay, onPart);
      const away = onRay.distanceTo(ray.origin);
      if (apart < radius * radius) {
        // The ray enters the round branch this far before the point where it comes nearest to the axis.
        const distance = Math.max(0, away - Math.sqrt(radius * radius - apart));
        if (!hit || distance < best) {
          hit = true;
          best = distance;
          found = { point: ray.at(distance, new Vector3()), piece };
        }
      } else if (!hit && near > 0) {
        const beside = (Math.sqrt(apart) - radius) / Math.max(away, 1e-3);
        if (beside < near && beside < best) {
          best = beside;
          found = { point: onPart.clone(), piece };
        }
      }
      a.copy(b);
    }
  }
  return found;
}

/** Where a ray first meets the crown, taken as an ellipsoid, or null. `crown` as in PackedTree. */
export function pickCrown(crown: Float32Array, ray: Ray, box: Box3): Vector3 | null {
  if (!ray.intersectsBox(box)) return null;
  const centre = new Vector3().fromArray(crown, 0);
  const radii = new Vector3().fromArray(crown, 3);
  const from = ray.origin.clone().sub(centre).divide(radii);
  const along = ray.direction.clone().divide(radii);
  const qa = along.lengthSq();
  const qb = from.dot(along);
  const root = qb * qb - qa * (from.lengthSq() - 1);
  if (root < 0) return null;
  const t = (-qb - Math.sqrt(root)) / qa;
  return t < 0 ? null : ray.at(t, new Vector3());
}
