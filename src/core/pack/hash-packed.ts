import { BRANCH_LAYERS, MECHANICS, MECHANICS_SIZE, TEXEL } from './layout.ts';
import type { PackedTree } from './packed.ts';

const PRIME = 16777619;

/** FNV-1a over 32-bit words: one number for the bits of an array whose elements have four bytes. */
function words(hash: number, array: Float32Array | Uint32Array): number {
  const bits = new Uint32Array(array.buffer, array.byteOffset, array.length);
  for (let i = 0; i < bits.length; i++) hash = Math.imul(hash ^ bits[i], PRIME);
  return hash;
}

/** Layers of the branches that are told; JOINT only says again what the pieces' ORIENT does, and came after the first trees were numbered. */
const TOLD = BRANCH_LAYERS.JOINT;

/** The mechanics without the damping, which came later too. */
const toldMechanics = (mechanics: Float32Array): Float32Array =>
  mechanics.filter((_, i) => i % MECHANICS_SIZE !== MECHANICS.DAMPING);

/** One number for all that the GPU gets of a tree: equal in Node and in every browser for the same species and seed. */
export function hashPacked(packed: PackedTree): string {
  let hash = words(2166136261 | 0, Uint32Array.of(packed.pieceCount, packed.leafCount));
  hash = words(hash, packed.depthStart);
  const { branches } = packed;
  const told = branches.data.subarray(0, TOLD * branches.width * branches.height * TEXEL);
  for (const array of [packed.pieces, packed.restPose, { ...branches, layers: TOLD, data: told }, packed.leaves]) {
    hash = words(hash, Uint32Array.of(array.width, array.height, array.layers));
    hash = words(hash, array.data);
  }
  for (const { start, count } of packed.levels) hash = words(hash, Uint32Array.of(start, count));
  hash = words(hash, Float32Array.of(packed.leafLength));
  hash = words(hash, toldMechanics(packed.mechanics));
  hash = words(hash, packed.bounds);
  hash = words(hash, packed.crown);
  return (hash >>> 0).toString(16).padStart(8, '0');
}
