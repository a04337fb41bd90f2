/** The order of the pieces: by depth, then by parent, then as they came. */
export interface PieceOrder {
  readonly maxDepth: number;
  /** First place of each depth; maxDepth + 2 entries. */
  readonly depthStart: Uint32Array;
  /** Depth of each piece, in the order given. */
  readonly depth: Uint16Array;
  /** Which piece stands at each place. */
  readonly at: Uint32Array;
  /** The place of each piece: the inverse of `at`. */
  readonly place: Uint32Array;
}

/**
 * Sorts pieces by depth, then by the place of their parent, keeping the given order among children of one piece.
 *
 * `parent`: -1 for a root, else a lower index. A breadth-first walk is that order, so nothing is compared. Throws RangeError
 * where a piece is deeper than 65 534.
 */
export function orderPieces(parent: Int32Array): PieceOrder {
  const count = parent.length;
  const depth = new Uint16Array(count);
  // Children of piece p are child[childStart[p] .. childStart[p + 1]).
  const childStart = new Uint32Array(count + 2);
  let roots = 0;
  let maxDepth = 0;
  for (let i = 0; i < count; i++) {
    const p = parent[i];
    if (p < 0) {
      roots++;
      continue;
    }
    const d = depth[p] + 1;
    if (d > 65534) throw new RangeError('pieces: a chain of more than 65 534 pieces');
    depth[i] = d;
    if (d > maxDepth) maxDepth = d;
    childStart[p + 2]++;
  }
  for (let p = 2; p <= count; p++) childStart[p] += childStart[p - 1];
  const child = new Uint32Array(count - roots);
  const at = new Uint32Array(count);
  let filled = 0;
  for (let i = 0; i < count; i++) {
    if (parent[i] < 0) at[filled++] = i;
    else child[childStart[parent[i] + 1]++] = i;
  }
  const place = new Uint32Array(count);
  const depthStart = new Uint32Array(maxDepth + 2);
  depthStart.fill(count);
  if (count > 0) depthStart[0] = 0;
  for (let k = 0; k < count; k++) {
    const i = at[k];
    place[i] = k;
    if (depthStart[depth[i]] > k) depthStart[depth[i]] = k;
    for (let j = childStart[i]; j < childStart[i + 1]; j++) at[filled++] = child[j];
  }
  return { maxDepth, depthStart, depth, at, place };
}
