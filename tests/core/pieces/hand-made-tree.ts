import { readFileSync } from 'node:fs';
import type { Leaves, Stems, Tree } from '../../../src/core/grow/tree.ts';
import { combine, hashUnit } from '../../../src/core/math/hash.ts';
import type { Mat3, Vec3 } from '../../../src/core/math/vec3.ts';
import { add, cross, scale, transform, unit } from '../../../src/core/math/vec3.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';

/** A stem as a test writes it down. */
export interface HandStem {
  parent: number;
  parentZ?: number;
  level?: number;
  clone?: boolean;
  zStart?: number;
  /** Whole length; the polyline's own length where it is not given. */
  length?: number;
  radius?: number;
  nodes: Vec3[];
  /** Any vector across the first segment. */
  across?: Vec3;
}

/** A leaf as a test writes it down. */
export interface HandLeaf {
  stem: number;
  z: number;
  orientation?: [number, number, number, number];
}

export const anySpecies = parseSpecies(readFileSync('public/species/quaking-aspen.json', 'utf8')).species!;

/** A tree from stems and leaves written out by hand. */
export function treeOf(stems: HandStem[], leaves: HandLeaf[] = [], species = anySpecies): Tree {
  const nodeStart = new Uint32Array(stems.length + 1);
  const position: number[] = [];
  const frame: number[] = [];
  stems.forEach((stem, i) => {
    const { nodes } = stem;
    for (let k = 0; k < nodes.length; k++) {
      const j = Math.min(k, nodes.length - 2);
      const z = unit(add(nodes[j + 1], scale(nodes[j], -1)));
      const x = unit(cross(stem.across ?? (Math.abs(z[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]), z));
      position.push(...nodes[k]);
      frame.push(...x, ...cross(z, x), ...z);
    }
    nodeStart[i + 1] = position.length / 3;
  });
  const lengthOf = (nodes: Vec3[]): number =>
    nodes
      .slice(1)
      .reduce((sum, p, k) => sum + Math.hypot(p[0] - nodes[k][0], p[1] - nodes[k][1], p[2] - nodes[k][2]), 0);
  const made: Stems = {
    count: stems.length,
    level: Uint8Array.from(stems, (s) => s.level ?? (s.parent < 0 ? 0 : 1)),
    parent: Int32Array.from(stems, (s) => s.parent),
    parentZ: Float32Array.from(stems, (s) => s.parentZ ?? 0),
    clone: Uint8Array.from(stems, (s) => (s.clone ? 1 : 0)),
    length: Float32Array.from(stems, (s) => s.length ?? lengthOf(s.nodes)),
    zStart: Float32Array.from(stems, (s) => s.zStart ?? 0),
    baseRadius: Float32Array.from(stems, (s) => s.radius ?? 0.01),
    path: Uint32Array.from(stems, (_, i) => combine(7, i)),
    nodeStart,
    nodePosition: Float32Array.from(position),
    nodeFrame: Float32Array.from(frame),
  };
  const grown: Leaves = {
    count: leaves.length,
    stem: Int32Array.from(leaves, (l) => l.stem),
    z: Float32Array.from(leaves, (l) => l.z),
    orientation: Float32Array.from(leaves.flatMap((l) => l.orientation ?? [0, 0, 0, 1])),
    length: new Float32Array(leaves.length).fill(0.05),
    phase: Float32Array.from(leaves, (_, i) => hashUnit(combine(9, i))),
  };
  return { species, seed: 7, scale: 10, stems: made, leaves: grown };
}

/** A polyline of equal steps that turns by `turns[i]` radians about the local x axis before segment i, then twists about z. */
export function polyline(start: Vec3, frame: Mat3, step: number, turns: number[], twists: number[] = []): Vec3[] {
  let [x, y, z] = frame;
  const nodes = [start];
  turns.forEach((turn, i) => {
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    [y, z] = [add(scale(y, c), scale(z, s)), add(scale(z, c), scale(y, -s))];
    const [ct, st] = [Math.cos(twists[i] ?? 0), Math.sin(twists[i] ?? 0)];
    [x, y] = [add(scale(x, ct), scale(y, st)), add(scale(y, ct), scale(x, -st))];
    nodes.push(add(nodes[i], scale(z, step)));
  });
  return nodes;
}

/** The tree-space frame x, y, z. */
export const upright: Mat3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** A random tree of four levels with bent, twisted and cloned stems; `seed` decides everything. */
export function randomTree(seed: number, counts: readonly number[] = [1, 12, 6, 3], leavesEach = 2): Tree {
  let draws = 0;
  const random = (): number => hashUnit(combine(seed, draws++));
  const spread = (a: number): number => a * (2 * random() - 1);
  const stems: HandStem[] = [];
  const leaves: HandLeaf[] = [];
  const add1 = (parent: number, parentZ: number, level: number, at: Vec3, base: Mat3, length: number): void => {
    const segments = [8, 5, 10, 1][level];
    const turns = Array.from({ length: segments }, (_, i) => (i === 0 ? 0 : spread([0.1, 0.5, 0.6, 0][level])));
    const twists = turns.map(() => spread(1));
    const nodes = polyline(at, base, length / segments, turns, twists);
    const index = stems.length;
    stems.push({ parent, parentZ, level, nodes, radius: length / 50, length });
    if (level < 3 && random() < 0.3) {
      const z = 0.5 * (1 + Math.floor(random() * segments) / segments);
      const split = nodes[Math.round(z * segments)];
      const left = segments - Math.round(z * segments);
      if (left > 0) {
        const bend = turns.slice(0, left).map(() => spread(0.4));
        const clone = polyline(split, tilted(base, spread(1), 0.5), length / segments, bend);
        const zStart = 1 - left / segments;
        stems.push({ parent: index, parentZ: zStart, zStart, level, clone: true, nodes: clone, length });
      }
    }
    if (level === 3)
      for (let k = 0; k < leavesEach; k++) leaves.push({ stem: index, z: random(), orientation: turn4(random) });
    for (let k = 0; k < (counts[level + 1] ?? 0); k++) {
      const z = 0.1 + 0.9 * random();
      const j = Math.min(segments - 1, Math.floor(z * segments));
      const f = z * segments - j;
      const from = add(scale(nodes[j], 1 - f), scale(nodes[j + 1], f));
      add1(index, z, level + 1, from, tilted(base, 2 * Math.PI * random(), 0.5 + random()), length * 0.4);
    }
  };
  for (let k = 0; k < counts[0]; k++) add1(-1, 0, 0, [k, 0, 0], upright, 10);
  return treeOf(stems, leaves);
}

/** A base turned by `around` about its z, then by `down` about its x. */
function tilted(base: Mat3, around: number, down: number): Mat3 {
  const [c, s] = [Math.cos(around), Math.sin(around)];
  const [cd, sd] = [Math.cos(down), Math.sin(down)];
  const columns: Mat3 = [
    [c, s, 0],
    [-s * cd, c * cd, sd],
    [s * sd, -c * sd, cd],
  ];
  return [transform(base, columns[0]), transform(base, columns[1]), transform(base, columns[2])];
}

function turn4(random: () => number): [number, number, number, number] {
  const q = [0, 0, 0, 0].map(() => random() - 0.5);
  const n = Math.hypot(...q);
  return [q[0] / n, q[1] / n, q[2] / n, q[3] / n];
}
