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

/**
 * Where a ray in tree space first meets a branch at rest, within the first `places` of the draw order, or null.
 *
 * The pose of the moment lives on the GPU; a branch is seldom farther from its rest than the pointer is from it.
 */
export function pickBranch(tree: PackedTree, ray: Ray, places: number): { point: Vector3; piece: number } | null {
  const { branches, restPose } = tree;
  const plane = restPose.width * restPose.height * TEXEL;
  const span = BRANCH_LAYERS.SPAN * branches.width * branches.height * TEXEL;
  let best = Number.POSITIVE_INFINITY;
  let found: { point: Vector3; piece: number } | null = null;
  for (let i = 0; i < places; i++) {
    const t = span + i * TEXEL;
    const piece = branches.data[t] as number;
    const z0 = branches.data[t + 1] as number;
    const z1 = branches.data[t + 2] as number;
    const base = branches.data[t + 3] as number;
    for (let k = 0; k < 4; k++) (corner[k] as Vector3).fromArray(restPose.data, k * plane + piece * TEXEL);
    // A sphere around the control polygon's ends rules most pieces out.
    a.addVectors(corner[0], corner[3]).multiplyScalar(0.5);
    const reach = Math.max(a.distanceTo(corner[0]), a.distanceTo(corner[1]), a.distanceTo(corner[2])) + base + SLACK;
    if (ray.distanceSqToPoint(a) > reach * reach) continue;
    bezier(0, a);
    for (let part = 1; part <= PARTS; part++) {
      bezier(part / PARTS, b);
      const radius = base * (1 - (z0 + ((z1 - z0) * (part - 0.5)) / PARTS)) + SLACK;
      const apart = ray.distanceSqToSegment(a, b, onRay, onPart);
      if (apart < radius * radius) {
        // The ray enters the round branch this far before the point where it comes nearest to the axis.
        const distance = Math.max(0, onRay.distanceTo(ray.origin) - Math.sqrt(radius * radius - apart));
        if (distance < best) {
          best = distance;
          found = { point: ray.at(distance, new Vector3()), piece };
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
