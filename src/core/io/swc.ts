import { stemRadius } from '../deform/radius.ts';
import { bezierPoint, type Cubic } from '../math/bezier.ts';
import type { Vec3 } from '../math/vec3.ts';
import { levelShape } from '../mesh/level-shape.ts';
import type { GrownPacked } from '../pack/grow-packed.ts';
import type { Pieces } from '../pieces/pieces.ts';
import { textFile } from './export-species.ts';
import type { WriteFormat } from './export-tree.ts';

export interface SwcOptions {
  /** Levels of stems that are written, from the trunk on. */
  readonly levels: number;
  /** Address that opens the tree again, '' for none. */
  readonly link: string;
}

/** The type of a node is this plus the level of its stem: SWC leaves numbers from 7 on to their users. */
export const SWC_TRUNK = 10;

/** Nodes along a piece besides those from which others grow. */
const NODES = 3;

/** Places on a piece that are nearer to each other than this part of it are one node. */
const SAME = 1e-4;

/**
 * The skeleton of a tree as SWC: a line a node, `id type x y z radius parent`, metres, z up, parents before children, one root.
 *
 * Nodes lie on the curves that are drawn, also where others grow from them; the first node of a branch stands where it leaves its
 * parent's wood. Radii are without lobes. Leaves are not written. Several trunks hang on a root of their own.
 */
export function writeSwc(grown: GrownPacked, { levels, link }: SwcOptions): string {
  const { tree, pieces } = grown;
  const { species, seed, stems } = tree;
  const lines = [
    `# ${species.name.replace(/[\r\n]/g, ' ')}, seed ${seed}, by Windgrove`,
    ...(link === '' ? [] : [`# ${link.replace(/[\r\n]/g, ' ')}`]),
    '# metres; x and y along the ground, z up',
    `# type: ${SWC_TRUNK} trunk, ${SWC_TRUNK + 1} main branches, ${SWC_TRUNK + 2} and more those of the next levels`,
    '# id type x y z radius parent',
  ];
  const places = placesOf(pieces, levels);
  let id = 0;
  const write = (type: number, at: Readonly<Vec3>, radius: number, parent: number): number => {
    id += 1;
    lines.push(`${id} ${type} ${at.map((x) => x.toFixed(5)).join(' ')} ${Math.max(radius, 1e-5).toFixed(5)} ${parent}`);
    return id;
  };
  const radiusAt = (piece: number, v: number): number => {
    const stem = pieces.stem[piece]!;
    const z = pieces.span[2 * piece]! * (1 - v) + pieces.span[2 * piece + 1]! * v;
    return stemRadius(levelShape(species, pieces.level[piece]!), stems.baseRadius[stem]!, stems.length[stem]!, z, 0)[0];
  };
  const nodes = new Map<number, number[]>();
  const roots = pieces.depthStart[1]!;
  let ground = -1;
  if (roots > 1) ground = write(SWC_TRUNK, [0, 0, 0], radiusAt(0, 0), -1);
  for (let i = 0; i < pieces.count; i++) {
    if (pieces.level[i]! >= levels) continue;
    const type = SWC_TRUNK + pieces.level[i]!;
    const curve = curveOf(pieces, i);
    const parent = pieces.parent[i]!;
    const root = parent < 0;
    const own: number[] = [];
    nodes.set(i, own);
    const list = places.get(i)!;
    // A clone and the next piece of a chain go on as thick as what they leave; anything else has come out of its parent's wood.
    if (!root && pieces.next[parent] !== i && stems.clone[pieces.stem[i]!] === 0) {
      const out = Math.min(0.3, radiusAt(parent, pieces.v[i]!) / Math.max(pieces.arc[i]!, 1e-9));
      if (list.every((v) => v > out + 0.02)) list.unshift(out);
    }
    // The foot of a trunk is a node; where anything else starts, its parent has one.
    let last = root
      ? write(type, curve.p0, radiusAt(i, 0), ground)
      : nodes.get(parent)![placeOf(places.get(parent)!, pieces.v[i]!)]!;
    for (const v of list) {
      if (v > 0) last = write(type, bezierPoint(curve, v), radiusAt(i, v), last);
      own.push(last);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** The places along each piece that have a node, growing: some of its own, and all where another piece grows. */
function placesOf(pieces: Pieces, levels: number): Map<number, number[]> {
  const all = new Map<number, number[]>();
  for (let i = 0; i < pieces.count; i++) {
    if (pieces.level[i]! >= levels) continue;
    all.set(
      i,
      Array.from({ length: NODES }, (_, k) => (k + 1) / NODES),
    );
    const parent = pieces.parent[i]!;
    if (parent >= 0) all.get(parent)!.push(pieces.v[i]!);
  }
  for (const [piece, list] of all) {
    list.sort((a, b) => a - b);
    all.set(
      piece,
      list.filter((v, k) => k === 0 || v - list[k - 1]! > SAME),
    );
  }
  return all;
}

/** The index of the place at v, or of the one that stands for it. */
function placeOf(list: readonly number[], v: number): number {
  let low = 0;
  let high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (list[middle]! <= v) low = middle;
    else high = middle - 1;
  }
  return low;
}

function curveOf({ control }: Pieces, piece: number): Cubic {
  const point = (k: number): Vec3 => [0, 1, 2].map((axis) => control[12 * piece + 3 * k + axis]!) as Vec3;
  return { p0: point(0), p1: point(1), p2: point(2), p3: point(3) };
}

/** The skeleton as one text file. */
export const exportSwc: WriteFormat = ({ grown, options, name }) => [
  textFile(`${name}.swc`, writeSwc(grown(), options), 'text/plain'),
];
