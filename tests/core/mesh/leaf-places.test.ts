import { describe, expect, it } from 'vitest';
import { rotateByQuaternion } from '../../../src/core/math/quaternion.ts';
import type { LeafPlacements } from '../../../src/core/mesh/leaf-placements.ts';
import { meshTree } from '../../../src/core/mesh/tree-mesh.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { edit } from '../grow/species.ts';
import { SMALL } from './small-trees.ts';

const full = growPacked(SMALL.aspen!, 3);
const all = full.packed.leafCount;
/** The same tree with another foliage or organ. */
const dressed = (changes: Parameters<typeof edit>[1]): typeof full => ({
  ...full,
  tree: { ...full.tree, species: edit(SMALL.aspen!, changes) },
});
const ends = ({ leaf }: LeafPlacements): number => Math.max(...leaf.position);

describe('leaves and organs of a mesh', () => {
  it('has the part of the leaves that are there, the first of the draw order, no larger than all were', () => {
    const whole = meshTree(full, { detail: 'medium' }).leaves!;
    const half = meshTree(dressed({ foliage: { cover: 0.5 } }), { detail: 'medium' }).leaves!;
    expect(whole.count).toBe(all);
    expect(half.count).toBe(Math.round(all / 2));
    expect([...half.position]).toEqual([...whole.position.subarray(0, 3 * half.count)]);
    expect(ends(half)).toBe(ends(whole));
    // A grade that keeps fewer makes up for those alone.
    const low = meshTree(dressed({ foliage: { cover: 0.5 } }), { detail: 'low' }).leaves!;
    expect(low.count).toBe(Math.ceil(0.6 * Math.round(all / 2)));
    expect(ends(low) / ends(meshTree(full, { detail: 'low' }).leaves!)).toBeCloseTo(1, 1);
    expect(meshTree(dressed({ foliage: { cover: 0 } }), { detail: 'medium' }).leaves).toBeNull();
  });

  it('bears organs at its share of the places, also where it has no leaves, and fruit hangs', () => {
    const mesh = meshTree(dressed({ foliage: { cover: 0 }, organ: { kind: 'fruit', share: 0.25, size: 0.04 } }), {
      detail: 'medium',
    });
    const organs = mesh.organs!;
    expect(mesh.leaves).toBeNull();
    expect(organs.count).toBe(Math.round(all / 4));
    for (let i = 0; i < organs.count; i++) {
      const q = [...organs.quaternion.subarray(4 * i, 4 * i + 4)] as [number, number, number, number];
      expect(Math.hypot(...q)).toBeCloseTo(1, 5);
      expect(rotateByQuaternion(q, [0, 0, 1])[2]).toBeLessThan(-0.8);
    }
    const { position } = organs.leaf;
    const across = position.filter((_, k) => k % 3 === 0);
    expect(Math.max(...across) - Math.min(...across)).toBeGreaterThan(0.03);
    expect(Math.max(...across) - Math.min(...across)).toBeLessThan(0.041);
    expect(meshTree(full, { detail: 'medium' }).organs).toBeNull();
  });
});
