import { BRANCH_LAYERS, TEXEL } from '../pack/layout.ts';
import type { PackedTree } from '../pack/packed.ts';
import { layerStart, texelArray, wordTexels } from '../pack/texel-array.ts';
import type { Clumps } from './clumps.ts';

/** One clump of a tree with nothing around it: its twigs and leaves where they are, in the pieces of the whole tree. For its picture. */
export function clumpTree(tree: PackedTree, clumps: Clumps, clump: number): PackedTree {
  const span = layerStart(tree.branches, BRANCH_LAYERS.SPAN);
  const lists = tree.levels.map(({ start, count }) => {
    const places = Array.from({ length: count }, (_, k) => start + k);
    return places.filter((place) => clumps.ofPiece[tree.branches.data[span + TEXEL * place]!] === clump);
  });
  const places = lists.flat();
  const branches = texelArray(places.length, tree.branches.layers);
  for (let layer = 0; layer < branches.layers; layer++) {
    const from = layerStart(tree.branches, layer);
    places.forEach((place, k) => {
      const texel = tree.branches.data.subarray(from + TEXEL * place, from + TEXEL * (place + 1));
      branches.data.set(texel, layerStart(branches, layer) + TEXEL * k);
    });
  }
  const own = Array.from({ length: tree.leafCount }, (_, i) => i).filter((i) => clumps.ofLeaf[i] === clump);
  const leaves = wordTexels(own.length, 1);
  own.forEach((i, k) => {
    leaves.data.set(tree.leaves.data.subarray(TEXEL * i, TEXEL * (i + 1)), TEXEL * k);
  });
  let start = 0;
  const levels = lists.map(({ length }) => {
    const range = { start, count: length };
    start += length;
    return range;
  });
  return { ...tree, branches, leaves, leafCount: own.length, levels };
}
