import { describe, expect, it } from 'vitest';
import { organCount } from '../../../src/core/look/leaf-count.ts';
import type { LeafGrain } from '../../../src/core/look/leaf-mesh.ts';
import { organMesh, organTriangles } from '../../../src/core/look/organ-mesh.ts';

const KINDS = ['blossom', 'fruit', 'cone', 'catkin'] as const;
const GRAINS: readonly LeafGrain[] = ['near', 'middle', 'far'];
const MOST: Readonly<Record<LeafGrain, number>> = { near: 160, middle: 36, far: 6 };

type Vector = [number, number, number];
const at = (array: Float32Array, i: number): Vector => [array[3 * i]!, array[3 * i + 1]!, array[3 * i + 2]!];

describe.each(KINDS)('organ: %s', (kind) => {
  it('takes few triangles from afar, each with an area and a normal on the side from which it is counter-clockwise', () => {
    for (const grain of GRAINS) {
      const { position, normal, blade, index, trianglesPerCopy } = organMesh(kind, grain, 1);
      expect(trianglesPerCopy).toBe(organTriangles(kind, grain));
      expect(trianglesPerCopy).toBeLessThanOrEqual(MOST[grain]);
      for (let t = 0; t < index.length; t += 3) {
        const corners = [index[t]!, index[t + 1]!, index[t + 2]!];
        const [a, b, c] = corners.map((i) => at(position, i)) as [Vector, Vector, Vector];
        const [u, v] = [b.map((x, k) => x - a[k]!), c.map((x, k) => x - a[k]!)] as [Vector, Vector];
        const face = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        expect(Math.hypot(...face)).toBeGreaterThan(1e-5);
        const towards = corners.reduce((sum, i) => sum + at(normal, i).reduce((s, x, k) => s + x * face[k]!, 0), 0);
        expect(towards).toBeGreaterThan(0);
      }
      for (let i = 0; i < position.length / 3; i++) {
        expect(Math.hypot(...at(normal, i))).toBeCloseTo(1, 5);
        expect(blade[4 * i]).toBeGreaterThanOrEqual(0);
        expect(blade[4 * i]).toBeLessThanOrEqual(1);
      }
    }
  });

  it.runIf(kind !== 'blossom')('is closed at every grain, but for its stalk', () => {
    for (const grain of GRAINS) {
      const { index, position } = organMesh(kind, grain, 1);
      const edges = new Map<string, number>();
      for (let t = 0; t < index.length; t += 3) {
        const corners = [index[t]!, index[t + 1]!, index[t + 2]!];
        // The stalk is a sliver of its own in the plane y = 0.
        if (corners.every((i) => position[3 * i + 1] === 0 && Math.abs(position[3 * i]!) < 0.021)) continue;
        corners.forEach((a, k) => {
          const b = corners[(k + 1) % 3]!;
          const [name, way] = a < b ? [`${a} ${b}`, 1] : [`${b} ${a}`, -1];
          edges.set(name, (edges.get(name) ?? 0) + way);
        });
      }
      expect([...edges.values()].every((sum) => sum === 0)).toBe(true);
    }
  });
});

it('stands at the first places of the draw order, so many as its share', () => {
  expect(organCount(1000, { kind: 'fruit', share: 0.05 })).toBe(50);
  expect(organCount(1000, { kind: 'none', share: 0.05 })).toBe(0);
});

it('has no mesh of no organ', () => {
  expect(() => organMesh('none', 'near', 1)).toThrow(/no organ/);
});
