import type { Frame } from './frame.ts';
import type { Stems } from './tree.ts';

/** A copy of a typed array with room for at least `needed` entries; twice as long as before, so that growing stays linear. */
export function widened<T extends Uint8Array | Int32Array | Uint32Array | Float32Array | Float64Array>(
  array: T,
  needed: number,
): T {
  const next = new (array.constructor as new (n: number) => T)(Math.max(needed, 2 * array.length));
  next.set(array);
  return next;
}

/** Stems while they are grown: the arrays of `Stems`, with room to grow, and what only growing needs. */
export class StemBuilder {
  count = 0;
  nodeCount = 0;
  level = new Uint8Array(1024);
  parent = new Int32Array(1024);
  parentZ = new Float32Array(1024);
  clone = new Uint8Array(1024);
  length = new Float32Array(1024);
  zStart = new Float32Array(1024);
  baseRadius = new Float32Array(1024);
  path = new Uint32Array(1024);
  nodeStart = new Uint32Array(1024);
  nodePosition = new Float32Array(3 * 4096);
  nodeFrame = new Float32Array(9 * 4096);

  /** The stem that this one is a clone of, at any remove; itself where it is none. */
  family = new Int32Array(1024);
  /** nLength +- nLengthV as drawn for the stem. */
  relative = new Float64Array(1024);
  /** Radius of the parent where the stem starts, in metres. */
  inside = new Float32Array(1024);
  /** Share of the stem's children that the segment at a node bears: 1, less where clones run beside it. */
  share = new Float32Array(4096);

  /** Makes room for a stem with this many nodes and takes it up; the caller writes the nodes. Returns its index. */
  add(nodes: number): number {
    const i = this.count;
    if (i + 1 >= this.level.length) this.widenStems(i + 2);
    if (this.nodeCount + nodes > this.share.length) this.widenNodes(this.nodeCount + nodes);
    this.nodeStart[i] = this.nodeCount;
    this.count = i + 1;
    this.nodeCount += nodes;
    this.nodeStart[i + 1] = this.nodeCount;
    return i;
  }

  /** Forgets stem `first` and all after it. */
  truncate(first: number): void {
    this.count = first;
    this.nodeCount = this.nodeStart[first];
  }

  writeNode(node: number, x: number, y: number, z: number, f: Frame, share: number): void {
    const p = this.nodePosition;
    p[3 * node] = x;
    p[3 * node + 1] = y;
    p[3 * node + 2] = z;
    const frames = this.nodeFrame;
    for (let i = 0; i < 9; i++) frames[9 * node + i] = f[i];
    this.share[node] = share;
  }

  /** The arrays at their exact size. */
  finish(): Stems {
    const n = this.count;
    return {
      count: n,
      level: this.level.slice(0, n),
      parent: this.parent.slice(0, n),
      parentZ: this.parentZ.slice(0, n),
      clone: this.clone.slice(0, n),
      length: this.length.slice(0, n),
      zStart: this.zStart.slice(0, n),
      baseRadius: this.baseRadius.slice(0, n),
      path: this.path.slice(0, n),
      nodeStart: this.nodeStart.slice(0, n + 1),
      nodePosition: this.nodePosition.slice(0, 3 * this.nodeCount),
      nodeFrame: this.nodeFrame.slice(0, 9 * this.nodeCount),
    };
  }

  private widenStems(needed: number): void {
    this.level = widened(this.level, needed);
    this.parent = widened(this.parent, needed);
    this.parentZ = widened(this.parentZ, needed);
    this.clone = widened(this.clone, needed);
    this.length = widened(this.length, needed);
    this.zStart = widened(this.zStart, needed);
    this.baseRadius = widened(this.baseRadius, needed);
    this.path = widened(this.path, needed);
    this.nodeStart = widened(this.nodeStart, needed);
    this.family = widened(this.family, needed);
    this.relative = widened(this.relative, needed);
    this.inside = widened(this.inside, needed);
  }

  private widenNodes(needed: number): void {
    this.share = widened(this.share, needed);
    const room = this.share.length;
    this.nodePosition = widened(this.nodePosition, 3 * room);
    this.nodeFrame = widened(this.nodeFrame, 9 * room);
  }
}
