import { describe, expect, it } from 'vitest';
import { type LeafGrain, leafMesh, leafTriangles } from '../../src/core/look/leaf-mesh.ts';
import { LEAF_SHAPES } from '../../src/core/look/leaf-outline.ts';
import { gridDetail, leafGrain, leafGrowth, leavesDrawn } from '../../src/view/detail.ts';

const GRAINS: readonly LeafGrain[] = ['near', 'middle', 'far'];

/** Do two segments cross, ends aside? */
function cross(a: readonly number[], b: readonly number[], c: readonly number[], d: readonly number[]): boolean {
  const side = (p: readonly number[], q: readonly number[], r: readonly number[]) =>
    Math.sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** Area of the blade seen from above. */
function area(shape: number, grain: LeafGrain): number {
  const { position, index } = leafMesh(shape, 1, 0, grain, 1);
  let sum = 0;
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [index[t] * 3, index[t + 1] * 3, index[t + 2] * 3];
    const ux = position[b] - position[a];
    const uz = position[b + 2] - position[a + 2];
    const vx = position[c] - position[a];
    const vz = position[c + 2] - position[a + 2];
    sum += (uz * vx - ux * vz) / 2;
  }
  return sum;
}

describe.each(LEAF_SHAPES.map((shape, i) => [shape.name, i] as const))('leaf outline: %s', (_, shape) => {
  it.each(GRAINS)(
    '%s starts at the base, ends at the tip, stays within half a width, and does not cross itself',
    (grain) => {
      const half = LEAF_SHAPES[shape][grain];
      expect(half[0]).toEqual([0, 0]);
      expect(half[half.length - 1]).toEqual([0, 1]);
      for (const [x] of half) {
        expect(x).toBeGreaterThanOrEqual(0);
        // A kite of few corners is a little wider, to cover as much.
        expect(x).toBeLessThanOrEqual(grain === 'far' ? 0.65 : 0.5);
      }
      for (let i = 0; i + 1 < half.length; i++) {
        for (let j = i + 2; j + 1 < half.length; j++) {
          expect(cross(half[i], half[i + 1], half[j], half[j + 1]), `edges ${i} and ${j}`).toBe(false);
        }
      }
    },
  );

  it('has as many triangles as it is said to have', () => {
    for (const grain of GRAINS) {
      for (const petiole of [0, 0.1, 0.6]) {
        const { trianglesPerCopy } = leafMesh(shape, 1, petiole, grain, 1);
        expect(trianglesPerCopy).toBe(leafTriangles(shape, petiole, grain));
      }
    }
  });

  it('covers about the same area however finely it is drawn', () => {
    const near = area(shape, 'near');
    expect(near).toBeGreaterThan(0.2);
    for (const grain of GRAINS) expect(area(shape, grain) / near).toBeCloseTo(1, 0.6); // within an eighth
  });

  it('is symmetric, and its upper side looks up', () => {
    for (const grain of GRAINS) {
      const { position, normal, index } = leafMesh(shape, 0.7, 0.5, grain, 1);
      const points = new Set<string>();
      const name = (x: number, y: number, z: number) =>
        [Math.abs(x) < 5e-6 ? 0 : x, y, z].map((v) => v.toFixed(4)).join();
      for (let i = 0; i < position.length; i += 3) points.add(name(position[i], position[i + 1], position[i + 2]));
      for (let i = 0; i < position.length; i += 3) {
        expect(points).toContain(name(-position[i], position[i + 1], position[i + 2]));
        expect(Math.hypot(normal[i], normal[i + 1], normal[i + 2])).toBeCloseTo(1, 5);
        expect(normal[i + 1]).toBeGreaterThan(0.5);
      }
      for (let t = 0; t < index.length; t += 3) {
        const [a, b, c] = [index[t] * 3, index[t + 1] * 3, index[t + 2] * 3];
        const up =
          (position[b + 2] - position[a + 2]) * (position[c] - position[a]) -
          (position[b] - position[a]) * (position[c + 2] - position[a + 2]);
        expect(up).toBeGreaterThan(0);
      }
    }
  });
});

describe('leaf mesh', () => {
  it('numbers the copies of a bundle', () => {
    const one = leafMesh(0, 1, 0.5, 'middle', 1);
    const { blade, index, position } = leafMesh(0, 1, 0.5, 'middle', 3);
    expect(position.length).toBe(3 * one.position.length);
    expect(blade[one.verticesPerCopy * 2 * 4 + 2]).toBe(2);
    expect(Math.max(...index)).toBe(3 * one.verticesPerCopy - 1);
  });

  it('hangs the blade at the end of its petiole', () => {
    const { position, blade } = leafMesh(0, 1, 0.6, 'near', 1);
    for (let i = 0; i < position.length / 3; i++) {
      if (blade[i * 4 + 3] === 0) expect(position[i * 3 + 2]).toBeGreaterThan(0.6 - 1e-6);
    }
  });

  it('refuses a shape that it does not have', () => {
    expect(() => leafMesh(6, 1, 0, 'near', 1)).toThrow(/0 to 5, found 6/);
  });
});

describe('leaf budget', () => {
  it('keeps the cover: width times length grows as the leaves get fewer', () => {
    for (const ratio of [0.2, 0.66, 1, 2]) {
      const [width, length] = leafGrowth(0.25, ratio);
      expect(width * length).toBeCloseTo(4, 12);
      expect(width).toBeGreaterThanOrEqual(length);
    }
    expect(leafGrowth(1, 0.2)).toEqual([1, 1]);
  });

  it('draws all leaves that can be told apart, and of smaller ones as many as cover the same at four pixels', () => {
    expect(leavesDrawn(10_000, 4, 1e6, 'auto')).toBe(10_000);
    expect(leavesDrawn(10_000, 40, 1e6, 'auto')).toBe(10_000);
    expect(leavesDrawn(10_000, 40, 300, 'auto')).toBe(300);
    for (const length of [3.9, 2, 0.7]) {
      const drawn = leavesDrawn(10_000, length, 1e6, 'auto');
      const grown = length * Math.sqrt(10_000 / drawn);
      expect(grown).toBeGreaterThanOrEqual(3.99);
      expect(grown).toBeLessThan(4.2);
    }
    expect(leavesDrawn(10_000, 0, 1e6, 'auto')).toBe(1);
  });

  it('draws stems too thin to be seen bending as ribbons of two parts', () => {
    expect(gridDetail(2, 0.5, 1000, 'auto')).toEqual({ sectors: 1, bands: 4 });
    expect(gridDetail(2, 0.1, 1000, 'auto')).toEqual({ sectors: 1, bands: 2 });
  });

  it('draws leaves coarser the smaller they are, and the more there are', () => {
    const cost = (grain: LeafGrain) => leafTriangles(0, 0.6, grain);
    expect(leafGrain(100, 1000, cost, 'auto')).toBe('near');
    expect(leafGrain(100, 60_000, cost, 'auto')).toBe('middle');
    expect(leafGrain(100, 600_000, cost, 'auto')).toBe('far');
    expect(leafGrain(4, 1000, cost, 'auto')).toBe('far');
    expect(leafGrain(4, 1000, cost, 'high')).toBe('middle');
  });
});
