// Does the order of the pieces matter to the wind pass? Sorted by depth and parent, as packed, beside shuffled within each depth.
import { WebGLRenderer } from 'three';
import { shippedWind } from '../e2e/pages/shipped-wind.ts';
import { hashPcg } from '../src/core/math/hash.ts';
import { PIECE_LAYERS } from '../src/core/pack/layout.ts';
import type { PackedTree, TexelArray } from '../src/core/pack/packed.ts';
import type { Wind } from '../src/core/wind/wind.ts';
import { syntheticTree } from '../src/gpu/crosscheck/synthetic-tree.ts';
import { interleave, type Subject } from '../src/gpu/interleave.ts';
import { rendererName } from '../src/gpu/renderer-name.ts';
import { STEP } from '../src/gpu/step.ts';
import { TreeTextures } from '../src/gpu/tree-textures.ts';
import { WindPass } from '../src/gpu/wind-pass.ts';
import { windSource } from '../src/gpu/wind-source.ts';
import type { BenchReport } from './report.ts';

const query = new URLSearchParams(location.search);
const SIZES = (query.get('sizes') ?? '16384,65536,262144').split(',').map(Number);
const ROUNDS = Number(query.get('rounds') ?? 9);

const renderer = new WebGLRenderer({ antialias: false });
const texel = new Float32Array(4);
const breeze: Wind = { ...(await shippedWind('breeze')), model: 'direct' };

/** The tree with the pieces of each depth in the order of a hash, and parents renumbered. */
function shuffled(tree: PackedTree): PackedTree {
  const placeOf = new Uint32Array(tree.pieceCount);
  for (let d = 0; d + 1 < tree.depthStart.length; d++) {
    const [start, end] = [tree.depthStart[d], tree.depthStart[d + 1]];
    const order = Array.from({ length: end - start }, (_, k) => start + k);
    order.sort((a, b) => hashPcg(a) - hashPcg(b));
    order.forEach((piece, k) => {
      placeOf[piece] = start + k;
    });
  }
  const moved = (array: TexelArray): TexelArray => {
    const data = new Float32Array(array.data.length);
    const plane = array.width * array.height * 4;
    for (let from = 0; from < data.length; from += plane) {
      for (let i = 0; i < tree.pieceCount; i++) {
        data.set(array.data.subarray(from + 4 * i, from + 4 * i + 4), from + 4 * placeOf[i]);
      }
    }
    return { ...array, data };
  };
  const pieces = moved(tree.pieces);
  const attach = PIECE_LAYERS.ATTACH * pieces.width * pieces.height * 4;
  for (let i = 0; i < tree.pieceCount; i++) {
    const parent = pieces.data[attach + 4 * i];
    if (parent >= 0) pieces.data[attach + 4 * i] = placeOf[parent];
  }
  return { ...tree, pieces, restPose: moved(tree.restPose) };
}

function measure(count: number): (string | number)[] {
  const sorted = syntheticTree(count, 7);
  const trees = [sorted, shuffled(sorted)];
  const textures = trees.map((tree) => new TreeTextures(tree, true));
  const winds = (['exact', 'lagged'] as const).map((pose) => windSource({ ...breeze, pose }));
  const passes: WindPass[] = [];
  const subjects = winds.flatMap((wind, w) =>
    textures.map((each, t): Subject => {
      const pass = new WindPass(each);
      passes.push(pass);
      let step = 0;
      return {
        name: `${w}${t}`,
        run: () => pass.update(renderer, ++step * STEP, wind),
        wait: () => renderer.readRenderTargetPixels(each.pose.targets![0], 0, 0, 1, 1, texel),
      };
    }),
  );
  const timings = interleave(subjects, ROUNDS);
  for (const it of [...passes, ...textures]) it.dispose();
  const [exact, exactShuffled, lagged, laggedShuffled] = timings.map(({ median }) => median);
  return [count, exact, exactShuffled, exactShuffled / exact, lagged, laggedShuffled, laggedShuffled / lagged];
}

const show = (id: string, text: string) => {
  document.getElementById(id)!.textContent = text;
};

async function run(): Promise<void> {
  const rows: (string | number)[][] = [];
  for (const size of SIZES) {
    show('state', `Measuring ${size} pieces …`);
    await new Promise((resolve) => setTimeout(resolve, 20));
    rows.push(measure(size));
  }
  const report: BenchReport = {
    title: 'Order of the pieces',
    renderer: rendererName(renderer),
    tables: [
      {
        caption:
          'Milliseconds a step of the wind pass, median: sorted by depth and parent, and shuffled within each depth',
        columns: ['pieces', 'exact, sorted', 'shuffled', 'ratio', 'lagged, sorted', 'shuffled', 'ratio'],
        rows,
      },
    ],
  };
  show('state', 'Done.');
  show('report', JSON.stringify(report, null, 1));
}

run();
