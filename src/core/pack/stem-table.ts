import { atan2 } from '../grow/elementary.ts';
import { RADIANS } from '../grow/plan.ts';
import type { Stems, Tree } from '../grow/tree.ts';
import type { Pieces } from '../pieces/pieces.ts';

/**
 * What a page says of the stems of a tree, and how it finds them: index i is one stem, clones among them, parents before children.
 *
 * Plain arrays, so that a worker hands them over. The GPU reads none of them.
 */
export interface StemTable {
  readonly count: number;
  /** The stem that each piece is a part of; as long as there are pieces. */
  readonly stemOfPiece: Int32Array;
  /** The piece that each stem begins with. */
  readonly firstPiece: Int32Array;
  /** Level of recursion, 0 for a trunk. `count` entries, as in all that follow unless it is said. */
  readonly level: Uint8Array;
  /** The stem that it grows on, or the twin of a clone; -1 for a trunk. */
  readonly parent: Int32Array;
  /** Where it grows there, as a fraction of the parent's whole length, 0..1. */
  readonly parentZ: Float32Array;
  /** 1 for a clone, else 0. */
  readonly clone: Uint8Array;
  /** Length in metres from base to tip; of a clone that of its twin, which it shares the lower part of. */
  readonly length: Float32Array;
  /** Radius in metres at the base, before taper, flare and lobes; of a clone that of its twin. */
  readonly radius: Float32Array;
  /** Degrees between its first segment and its parent's direction there; of a trunk and the vertical; of a clone and its twin before the split. */
  readonly downAngle: Float32Array;
  /** Hash of seed and path: the same stem of a tree that was grown anew has it again. */
  readonly path: Uint32Array;
  /** Its number among the stems of its level, from 1. */
  readonly numberInLevel: Uint32Array;
  /** Stems of each level; as long as there are levels. */
  readonly countOfLevel: Uint32Array;
  /** Where it begins and ends at rest, 3 a stem: metres, tree space. */
  readonly base: Float32Array;
  readonly tip: Float32Array;
}

/** The table of a tree's stems; arrays that `tree` and `pieces` have already are shared with them. */
export function stemTable({ stems }: Tree, pieces: Pieces): StemTable {
  const { count, level } = stems;
  let levels = 0;
  for (let i = 0; i < count; i++) levels = Math.max(levels, (level[i] as number) + 1);
  const countOfLevel = new Uint32Array(levels);
  const numberInLevel = new Uint32Array(count);
  const downAngle = new Float32Array(count);
  const base = new Float32Array(3 * count);
  const tip = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    numberInLevel[i] = ++countOfLevel[level[i]];
    downAngle[i] = turnAgainst(stems, 9 * stems.nodeStart[i] + 6, i);
    let last = pieces.firstOfStem[i];
    for (let k = 0; k < 3; k++) base[3 * i + k] = pieces.control[12 * last + k];
    while (pieces.next[last] >= 0) last = pieces.next[last];
    for (let k = 0; k < 3; k++) tip[3 * i + k] = pieces.control[12 * last + 9 + k];
  }
  return {
    count,
    stemOfPiece: pieces.stem,
    firstPiece: pieces.firstOfStem,
    level,
    parent: stems.parent,
    parentZ: stems.parentZ,
    clone: stems.clone,
    length: stems.length,
    radius: stems.baseRadius,
    downAngle,
    path: stems.path,
    numberInLevel,
    countOfLevel,
    base,
    tip,
  };
}

/** Every buffer of a table, for a worker to hand over. */
export const stemBuffers = (table: StemTable): ArrayBuffer[] =>
  Object.values(table).flatMap((part) => (typeof part === 'number' ? [] : [part.buffer as ArrayBuffer]));

/** Degrees between the direction of stem i, at `own` of the node frames, and that of its parent where it grows. */
function turnAgainst(stems: Stems, own: number, i: number): number {
  const { nodeFrame } = stems;
  const [x, y, z] = [nodeFrame[own], nodeFrame[own + 1], nodeFrame[own + 2]];
  const parent = stems.parent[i];
  if (parent < 0) return atan2(Math.sqrt(x * x + y * y), z) / RADIANS;
  const at = 9 * nodeBelow(stems, parent, stems.parentZ[i], stems.clone[i] === 1) + 6;
  const [u, v, w] = [nodeFrame[at], nodeFrame[at + 1], nodeFrame[at + 2]];
  const [cx, cy, cz] = [y * w - z * v, z * u - x * w, x * v - y * u];
  return atan2(Math.sqrt(cx * cx + cy * cy + cz * cz), x * u + y * v + z * w) / RADIANS;
}

/** A split stands at a node; rounding must not put it beside. */
const ROUNDING = 1e-4;

/** The node at which the segment of a stem starts that reaches z, a fraction of the whole length; `before`: that ends there. */
function nodeBelow({ nodeStart, zStart }: Stems, stem: number, z: number, before: boolean): number {
  const first = nodeStart[stem];
  const segments = nodeStart[stem + 1] - 1 - first;
  const at = ((z - zStart[stem]) / (1 - zStart[stem])) * segments;
  const segment = before ? Math.ceil(at - ROUNDING) - 1 : Math.floor(at);
  return first + Math.min(Math.max(segment, 0), segments - 1);
}
