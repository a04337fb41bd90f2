import { organCount } from '../look/leaf-count.ts';
import { ORGAN_HANG } from '../look/organ-hang.ts';
import { organMesh } from '../look/organ-mesh.ts';
import { rotateByQuaternion, writeQuaternion } from '../math/quaternion.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import { type LeafOutlineMesh, type LeafPlacementOptions, type LeafPlacements, placeFirst } from './leaf-placements.ts';

/** What twigs bear besides leaves, as it is drawn, or null where there is nothing. The `uv` of its mesh begin with the part of the second colour. */
export function placeOrgans(grown: GrownPacked, options: LeafPlacementOptions): LeafPlacements | null {
  const { organ } = grown.tree.species;
  const there = organCount(grown.packed.leafCount, organ);
  const drawn = Math.min(Math.ceil((options.share ?? 1) * there), Math.max(0, Math.floor(options.most)));
  if (drawn === 0) return null;
  const placed = placeFirst(grown, drawn, options);
  if (!placed) return null;
  hang(placed.quaternion, ORGAN_HANG[organ.kind]);
  // Fewer are larger, so that they cover as much.
  const size = organ.size * Math.sqrt(there / drawn);
  return { ...placed, leaf: oneOrgan(grown, options, size) };
}

function oneOrgan(grown: GrownPacked, { grain }: LeafPlacementOptions, size: number): LeafOutlineMesh {
  const { position, normal, blade, index } = organMesh(grown.tree.species.organ.kind, grain, 1);
  const uv = new Float32Array((2 * position.length) / 3);
  for (let i = 0; i < uv.length / 2; i++) uv[2 * i] = blade[4 * i]!;
  return { position: position.map((x) => x * size), normal, uv, index: Uint16Array.from(index) };
}

/** Turns each rotation so far that its z axis hangs down, as shaders/leaf/vertex.glsl does it. */
function hang(quaternion: Float32Array, amount: number): void {
  const columns = new Float64Array(9);
  for (let at = 0; at < quaternion.length; at += 4) {
    const q: [number, number, number, number] = [
      quaternion[at]!,
      quaternion[at + 1]!,
      quaternion[at + 2]!,
      quaternion[at + 3]!,
    ];
    const [x, y, z] = rotateByQuaternion(q, [0, 0, 1]);
    const [ax, ay, az] = unit([x * (1 - amount) + 0.001 * amount, y * (1 - amount), z * (1 - amount) - amount]);
    const [bx, by, bz] = rotateByQuaternion(q, [1, 0, 0]);
    // Twice over, so that the small part that keeps it from vanishing does not lean it.
    let side: Vector = [bx, by, bz];
    for (const more of [0.01, 0]) {
      const along = side[0] * ax + side[1] * ay + side[2] * az;
      side = unit([side[0] - ax * along + more, side[1] - ay * along + 1.3 * more, side[2] - az * along]);
    }
    const [sx, sy, sz] = side;
    columns.set([sx, sy, sz, ay * sz - az * sy, az * sx - ax * sz, ax * sy - ay * sx, ax, ay, az]);
    writeQuaternion(columns, quaternion, at);
  }
}

type Vector = [number, number, number];

function unit([x, y, z]: Vector): Vector {
  const n = 1 / Math.sqrt(x * x + y * y + z * z);
  return [x * n, y * n, z * n];
}
