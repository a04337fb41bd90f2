import { describe, expect, it } from 'vitest';
import { branchGrid, sectorsForLobes } from '../../src/view/grid.ts';

const tube = { sectors: 7, bands: 4, cap: false, bundle: 1 };

/** Corner of the unit cylinder that a vertex of the grid stands for; a cap's centre lies on the axis. */
function point(position: Float32Array, i: number): string {
  return [position[3 * i], position[3 * i + 1], position[3 * i + 2]].map((x) => x.toFixed(6)).join(' ');
}

/** Directed edges by their end points in space, so that both sides of the seam are one. */
function edges(grid: ReturnType<typeof branchGrid>): Map<string, number> {
  const count = new Map<string, number>();
  for (let t = 0; t < grid.index.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const a = point(grid.position, grid.index[t + k]);
      const b = point(grid.position, grid.index[t + ((k + 1) % 3)]);
      if (a !== b) count.set(`${a} > ${b}`, (count.get(`${a} > ${b}`) ?? 0) + 1);
    }
  }
  return count;
}

/** Edges that no triangle runs along the other way. */
const openEdges = (grid: ReturnType<typeof branchGrid>): string[] => {
  const all = edges(grid);
  return [...all.keys()].filter((edge) => all.get(edge.split(' > ').reverse().join(' > ')) !== all.get(edge));
};

describe('branch grid', () => {
  it('crowds its rows towards a round end, so that a half sphere there is no cone', () => {
    const rows = ({ position }: ReturnType<typeof branchGrid>) =>
      [0, 1, 2, 3, 4].map((row) => position[row * 8 * 3 + 2]);
    expect(rows(branchGrid(tube))).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(rows(branchGrid({ ...tube, round: true }))).toEqual([0, 0.4375, 0.75, 0.9375, 1]);
  });

  it('closes its seam to the bit: the last column has the numbers of the first', () => {
    const { position, shape } = branchGrid(tube);
    for (let row = 0; row <= 4; row++) {
      const first = row * 8;
      const last = first + 7;
      expect(position.slice(last * 3, last * 3 + 3)).toEqual(position.slice(first * 3, first * 3 + 3));
      expect([shape[first * 3], shape[last * 3]]).toEqual([0, 1]);
    }
  });

  it('has edges that are open at its two ends only', () => {
    const open = openEdges(branchGrid(tube));
    expect(open.length).toBe(14);
    for (const edge of open) expect(edge).toMatch(/ (0|1)\.000000 > .* (0|1)\.000000$/);
  });

  it('is closed at the tip by a cap', () => {
    const open = openEdges(branchGrid({ ...tube, cap: true }));
    expect(open.length).toBe(7);
    for (const edge of open) expect(edge).toMatch(/ 0\.000000$/);
  });

  it('turns its triangles outward', () => {
    const { position, index } = branchGrid(tube);
    // (L, T, S) is right-handed with theta from T to S: x = T, y = S, z = L.
    const at = (i: number) => [position[3 * i], position[3 * i + 1], position[3 * i + 2]];
    for (let t = 0; t < index.length; t += 3) {
      const [a, b, c] = [at(index[t]), at(index[t + 1]), at(index[t + 2])];
      const u = b.map((x, k) => x - a[k]);
      const v = c.map((x, k) => x - a[k]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      expect(n[0] * (a[0] + b[0] + c[0]) + n[1] * (a[1] + b[1] + c[1])).toBeGreaterThan(0);
    }
  });

  it('repeats the grid in a bundle, each copy with its number and its own vertices', () => {
    const one = branchGrid(tube);
    const many = branchGrid({ ...tube, bundle: 5 });
    expect(many.position.length).toBe(5 * one.position.length);
    for (let copy = 0; copy < 5; copy++) {
      const from = copy * one.verticesPerCopy;
      expect(many.shape[from * 3 + 1]).toBe(copy);
      const triangles = many.index.slice(copy * one.index.length, (copy + 1) * one.index.length);
      expect([...triangles].map((i) => i - from)).toEqual([...one.index]);
    }
  });

  it('takes 32-bit indices where 16 do not reach', () => {
    const grid = branchGrid({ sectors: 24, bands: 48, cap: true, bundle: 64 });
    expect(grid.index).toBeInstanceOf(Uint32Array);
    expect(Math.max(...grid.index.slice(-6))).toBeGreaterThan(65535);
  });

  it('makes a ribbon of two columns', () => {
    const { position, trianglesPerCopy } = branchGrid({ sectors: 1, bands: 3, cap: true, bundle: 1 });
    expect(trianglesPerCopy).toBe(6);
    expect([position[0], position[3]]).toEqual([-1, 1]);
  });

  it('says what is wrong with a spec', () => {
    expect(() => branchGrid({ ...tube, sectors: 2 })).toThrow(/sectors must be 1 or at least 3, found 2/);
    expect(() => branchGrid({ ...tube, bands: 0 })).toThrow(/at least 1, found 0/);
  });

  it('row 24: gives each lobe at least four sectors, and all of them the same number', () => {
    expect(sectorsForLobes(8, 5, 0.1)).toBe(20);
    expect(sectorsForLobes(24, 3, 0.1)).toBe(24);
    expect(sectorsForLobes(24, 5, 0.1)).toBe(25);
    expect(sectorsForLobes(8, 5, 0)).toBe(8);
    expect(sectorsForLobes(1, 5, 0.1)).toBe(1);
  });
});
