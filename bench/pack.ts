// Fitting and packing each species in Node, and the bytes of a tree on the GPU beside the same tree as an indexed mesh.
// `npx tsx bench/pack.ts` prints tables; with --json one line for `npm run bench`.
import { readFileSync } from 'node:fs';
import { grow } from '../src/core/grow/grow.ts';
import { packTree } from '../src/core/pack/pack.ts';
import type { PackedTree } from '../src/core/pack/packed.ts';
import { attachLeaves } from '../src/core/pieces/attach-leaves.ts';
import { fitPieces } from '../src/core/pieces/fit-pieces.ts';
import { parseSpecies } from '../src/core/species/parse.ts';
import { type BenchReport, sectionText } from './report.ts';

const SPECIES = ['quaking-aspen', 'black-tupelo', 'weeping-willow', 'california-black-oak'];
const ROUNDS = 11;

/** Grid of a piece by level that both ways draw: sectors around, bands along. */
const GRIDS = [
  [16, 18],
  [8, 10],
  [6, 6],
  [4, 4],
] as const;
/** A leaf is Weber & Penn's hexagon. */
const LEAF = { vertices: 6, triangles: 4 };
/** Bytes: position 12, normal 12, texture coordinates 8; a tangent for normal maps 16 more. */
const VERTEX = 32;
const TANGENT = 16;
const INDEX = 4;

const median = (values: readonly number[]): number => values.toSorted((a, b) => a - b)[values.length >> 1];

/** Milliseconds of each stage, medians over the rounds; the first two rounds warm up. */
function timesOf(species: Parameters<typeof grow>[0]): { packed: PackedTree; stages: number[] } {
  const rounds: number[][] = [];
  let packed: PackedTree | undefined;
  for (let round = 0; round < ROUNDS + 2; round++) {
    const t0 = performance.now();
    const tree = grow(species, 1);
    const t1 = performance.now();
    const pieces = fitPieces(tree);
    const t2 = performance.now();
    const leaves = attachLeaves(tree, pieces);
    const t3 = performance.now();
    packed = packTree(tree, pieces, leaves);
    const t4 = performance.now();
    if (round >= 2) rounds.push([t1 - t0, t2 - t1, t3 - t2, t4 - t3, t4 - t0]);
  }
  return { packed: packed!, stages: rounds[0].map((_, k) => median(rounds.map((r) => r[k]))) };
}

/** Bytes of the textures, with both pose sets that the wind pass writes. */
const textureBytes = ({ pieces, restPose, branches, leaves }: PackedTree): number =>
  pieces.data.byteLength + 2 * restPose.data.byteLength + branches.data.byteLength + leaves.data.byteLength;

function meshBytes({ levels, leafCount }: PackedTree, vertex: number): number {
  let bytes = leafCount * (LEAF.vertices * vertex + LEAF.triangles * 3 * INDEX);
  levels.forEach(({ count }, level) => {
    const [sectors, bands] = GRIDS[Math.min(level, GRIDS.length - 1)];
    bytes += count * ((sectors + 1) * (bands + 1) * vertex + sectors * bands * 6 * INDEX);
  });
  return bytes;
}

const mega = (bytes: number): number => bytes / 1e6;
const times: (string | number)[][] = [];
const bytes: (string | number)[][] = [];
for (const name of SPECIES) {
  const { species } = parseSpecies(readFileSync(new URL(`../public/species/${name}.json`, import.meta.url), 'utf8'));
  if (!species) throw new Error(`${name}: the species file is not valid`);
  const { packed, stages } = timesOf(species);
  times.push([species.name, packed.pieceCount, packed.leafCount, ...stages]);
  const own = textureBytes(packed);
  const plain = meshBytes(packed, VERTEX);
  const full = meshBytes(packed, VERTEX + TANGENT);
  bytes.push([species.name, mega(own), mega(plain), own / plain, mega(full), own / full]);
}

const report: BenchReport = {
  title: 'Fitting and packing',
  tables: [
    {
      caption: `Milliseconds in Node, warmed up, median of ${ROUNDS} rounds, seed 1; aim: all of it within 50 ms for the aspen`,
      columns: ['species', 'pieces', 'leaves', 'grow', 'fit stems', 'hang leaves', 'pack', 'all'],
      rows: times,
    },
    {
      caption: 'Megabytes on the GPU beside an indexed mesh of the same tree, which stands still; aim: a tenth',
      columns: ['species', 'Windgrove', 'mesh', 'part of it', 'mesh with tangents', 'part of that'],
      rows: bytes,
    },
  ],
  notes: [
    'Windgrove: 240 bytes a piece (rest data 80, draw order 32, two pose sets 128) and 16 bytes a leaf, one grid a level shared ' +
      'by all trees and not counted. Mesh: vertices of 32 bytes (position, normal, texture coordinates; 48 with a tangent), indices ' +
      `of 4 bytes, sectors x bands a piece ${GRIDS.map((grid) => grid.join(' x ')).join(', ')} by level with a doubled seam, a leaf of 6 ` +
      'vertices and 4 triangles. A mesh that moves would need bone indices and weights (8 bytes a vertex and more) besides.',
  ],
};

if (process.argv.includes('--json')) console.log(JSON.stringify(report));
else console.log(sectionText('pack', report, `Node ${process.version.slice(1)}`));
