import { describe, expect, test } from 'vitest';
import { SWC_TRUNK, writeSwc } from '../../../src/core/io/swc.ts';
import { bezierPoint } from '../../../src/core/math/bezier.ts';
import { growPacked } from '../../../src/core/pack/grow-packed.ts';
import { type SHIPPED, shippedSpecies } from '../pack/shipped-species.ts';
import { curveOf } from '../pieces/pose-at-rest.ts';

interface Node {
  readonly id: number;
  readonly type: number;
  readonly at: readonly [number, number, number];
  readonly radius: number;
  readonly parent: number;
}

/** Reads what the format says and no more. */
function parse(text: string): Node[] {
  return text
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#'))
    .map((line) => {
      const [id, type, x, y, z, radius, parent, ...rest] = line.split(' ').map(Number);
      expect(rest).toEqual([]);
      return { id: id!, type: type!, at: [x!, y!, z!], radius: radius!, parent: parent! };
    });
}

const away = (a: readonly number[], b: readonly number[]): number => Math.hypot(...a.map((x, k) => x - b[k]!));

describe.each<[(typeof SHIPPED)[number], number]>([
  ['quaking-aspen', 8],
  ['weeping-willow', 2],
])('the skeleton of %s', (name, levels) => {
  const grown = growPacked(shippedSpecies(name), 3, { levels: Math.min(levels, 8) });
  const { stems, pieces } = grown;
  const text = writeSwc(grown, { levels, link: 'https://example.org/#s=x' });
  const nodes = parse(text);

  test('has one root, numbers in a row, and parents before children', () => {
    expect(nodes.map(({ id }) => id)).toEqual(nodes.map((_, i) => i + 1));
    expect(nodes.filter(({ parent }) => parent === -1)).toHaveLength(1);
    expect(nodes.slice(1).every(({ id, parent }) => parent >= 1 && parent < id)).toBe(true);
    expect(nodes.every(({ radius, at }) => radius > 0 && at.every(Number.isFinite))).toBe(true);
  });

  test('has the tip of every stem, at its level, and is as long as the tree', () => {
    const ofType = new Map<number, Node[]>();
    for (const node of nodes) ofType.set(node.type, [...(ofType.get(node.type) ?? []), node]);
    for (let i = 0; i < stems.count; i++) {
      if (stems.level[i]! >= levels) continue;
      const tip = [0, 1, 2].map((k) => stems.tip[3 * i + k]!);
      const near = (ofType.get(SWC_TRUNK + stems.level[i]!) ?? []).some(({ at }) => away(at, tip) < 2e-5);
      if (!near) throw new Error(`no node at the tip of stem ${i}`);
    }
    const drawn = nodes.reduce(
      (sum, node) => sum + (node.parent < 0 ? 0 : away(node.at, nodes[node.parent - 1]!.at)),
      0,
    );
    let grownLength = 0;
    for (let p = 0; p < pieces.count; p++) if (pieces.level[p]! < levels) grownLength += pieces.arc[p]!;
    expect(Math.abs(drawn / grownLength - 1)).toBeLessThan(0.03);
  });

  test('has a node where a branch grows, on the curve of its parent', () => {
    let checked = 0;
    for (let p = 1; p < pieces.count; p += 5) {
      const q = pieces.parent[p]!;
      if (q < 0 || pieces.level[p]! >= levels) continue;
      const foot = bezierPoint(curveOf(pieces, q), pieces.v[p]!);
      const least = Math.min(...nodes.map(({ at }) => away(at, foot)));
      expect(least).toBeLessThan(1e-4 + 1e-4 * pieces.arc[q]!);
      checked += 1;
    }
    expect(checked).toBeGreaterThan(5);
  });

  test('gets thinner, and says what it is', () => {
    const bases = nodes.filter(({ type }) => type === SWC_TRUNK).map(({ radius }) => radius);
    expect(bases[0]).toBeGreaterThan(2 * bases.at(-1)!);
    expect(text).toContain(`# type: ${SWC_TRUNK} trunk`);
    expect(text).toContain('z up');
    expect(text).toContain('https://example.org/#s=x');
  });
});

test('several trunks hang on one root', () => {
  const species = shippedSpecies('quaking-aspen');
  const [trunk, ...others] = species.levels;
  const clump = { ...species, levels: [{ ...trunk!, branches: 3 }, ...others] };
  const nodes = parse(writeSwc(growPacked(clump, 1, { levels: 1 }), { levels: 1, link: '' }));
  expect(nodes.filter(({ parent }) => parent === -1)).toHaveLength(1);
  expect(nodes.filter(({ parent }) => parent === 1)).toHaveLength(3);
});
