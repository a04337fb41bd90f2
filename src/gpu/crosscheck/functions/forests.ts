import fadeFragment from '../../../../shaders/debug/check-fade.frag';
import octahedralFragment from '../../../../shaders/debug/check-octahedral.frag';
import texelFragment from '../../../../shaders/debug/check-texel.frag';
import { ditherAt, type Fade, treePixels, treeShare, treeShares } from '../../../core/forest/fade.ts';
import {
  fromHemiOctahedral,
  hemiOctahedral,
  nearestViews,
  viewDirection,
  viewFrame,
} from '../../../core/forest/octahedral.ts';
import type { Vec3 } from '../../../core/math/vec3.ts';
import { CARD_PICTURES, cardTexel, writeCard } from '../../../core/pack/card-texel.ts';
import { GROVE_PIECES, GROVE_TREES, groveLeaf, leafTexel, writeLeaf } from '../../../core/pack/leaf-texel.ts';
import type { CheckProgram } from '../program.ts';
import { between, direction, magnitude, type Random, rotation } from '../random.ts';

const octahedral: CheckProgram = {
  name: 'octahedral',
  fragment: octahedralFragment,
  layers: 2,
  edges: [
    // The zenith, the horizon, below it, and the corners of the square.
    [0, 0, 1, 8, 0, 0, 0, 0],
    [1, 0, 0, 8, 1, 1, 7, 7],
    [0.6, 0, -0.8, 8, -1, 1, 0, 7],
    [0, -1, 0, 4, 1, -1, 3, 0],
  ],
  inputs: (random) => {
    const views = 3 + Math.floor(10 * random());
    const cell = () => Math.floor(views * random());
    return [...direction(random), views, between(random, -1, 1), between(random, -1, 1), cell(), cell()];
  },
  twin: (g) => {
    const d: Vec3 = [g[0], g[1], g[2]];
    const views = g[3];
    const near = nearestViews(d, views).sort((a, b) => b.weight - a.weight);
    const mean = near.reduce((sum, { i, j, weight }) => {
      const [x, y] = [i / (views - 1), j / (views - 1)];
      return sum + weight * (x * x + 3 * y * y + 2 * x * y);
    }, 0);
    const { right, up } = viewFrame(d);
    const [x, y] = viewDirection(g[6], g[7], views);
    // The shader puts the heaviest first; of the others each weighs its own.
    const others = near.slice(1).map(({ weight }) => weight);
    return [
      ...hemiOctahedral(d),
      near[0].weight,
      mean,
      ...fromHemiOctahedral(g[4], g[5]),
      others[0] + others[1],
      ...right,
      ...up,
      x,
      y,
    ];
  },
  lines: [
    { name: 'hemiOctahedral', parts: [0, 1], tolerance: 2e-6, note: 'of the square -1..1' },
    { name: 'fromHemiOctahedral', parts: [4, 5, 6], tolerance: 2e-6, note: 'of a unit vector' },
    { name: 'viewDirection', parts: [14, 15], tolerance: 2e-6, note: 'of a unit vector' },
    { name: 'viewFrame', parts: [8, 9, 10, 11, 12, 13], tolerance: 4e-5, note: 'of unit vectors; near the zenith' },
    { name: 'nearestViews, weights', parts: [2, 7], tolerance: 2e-5, note: 'of 1, times the views' },
    { name: 'nearestViews, mean', parts: [3], tolerance: 2e-5, note: 'a mean over the three, as far as it goes on' },
  ],
};

const fade: CheckProgram = {
  name: 'fade',
  fragment: fadeFragment,
  layers: 5,
  edges: [
    // The eye in the tree; a class that comes at once; one that nothing is nearer than; the corner of the picture.
    [1, 2, 3, 10, 1, 2, 8, 500, 60, 80, 221, 299, 70, 1, 1, 0.5, 0.5],
    [0, 0, 0, 5, 0, 40, 2, 500, 70, 70, 221, 221, 70, 1, 1, 63.5, 63.5],
    [0, 0, 0, 5, 0, 40, 2, 500, -1, 0, 1e9, 2e9, 5, 1, 0, 7.5, 0.5],
  ],
  inputs: (random) => {
    const from = magnitude(random, 5, 300);
    const lost = from * between(random, 1.5, 6);
    const pixel = () => Math.floor(64 * random()) + 0.5;
    return [
      ...[between(random, -300, 300), between(random, -300, 300), between(random, -20, 90), magnitude(random, 1, 40)],
      ...[
        between(random, -300, 300),
        between(random, -300, 300),
        between(random, 2, 120),
        magnitude(random, 200, 2000),
      ],
      ...[from, from * 1.35, lost, lost * 1.35],
      ...[magnitude(random, 3, 1000), random(), random(), pixel()],
      pixel(),
    ];
  },
  twin: (g) => {
    const bands: Fade = [g[8], g[9], g[10], g[11]];
    const noise = 2 * Math.PI * ditherAt(g[15], g[16]);
    return [
      treePixels([g[0], g[1], g[2]], g[3], [g[4], g[5], g[6]], g[7]),
      treeShare(g[8], g[9], g[12]),
      ...treeShares(bands, g[12], g[13], g[14]),
      Math.cos(noise),
      Math.sin(noise),
      ...new Array<number>(10).fill(0),
    ];
  },
  lines: [
    { name: 'treePixels', parts: [0], relative: true, tolerance: 1e-5, note: 'part of the height on screen' },
    { name: 'treeShare', parts: [1], tolerance: 1e-4, note: 'of 1' },
    { name: 'treeShares', parts: [2, 3], tolerance: 1e-4, note: 'of 1' },
    {
      name: 'ditherAt',
      parts: [4, 5],
      tolerance: 1e-3,
      note: 'the angle of a noise whose last bits are multiplied by 53',
    },
  ],
};

/** The halves of four words, which floats hold exactly. */
const halves = (words: Uint32Array): number[] => [...words].flatMap((word) => [word & 0xffff, word >>> 16]);

/** The four words whose halves these are. */
const wordsOf = (given: readonly number[]): Uint32Array =>
  Uint32Array.from({ length: 4 }, (_, i) => (given[2 * i] | (given[2 * i + 1] << 16)) >>> 0);

function texelInputs(random: Random): number[] {
  // A piece of a grove with its tree above it is a number below 2^31, as the piece of a single tree is.
  const piece = () => Math.floor(GROVE_PIECES * random()) + GROVE_PIECES * Math.floor(GROVE_TREES * random());
  const card = new Uint32Array(4);
  const offset: Vec3 = [between(random, -3, 3), between(random, -3, 3), between(random, -3, 3)];
  const picture = Math.floor(CARD_PICTURES * random());
  const radius = magnitude(random, 0.05, 3);
  writeCard(card, 0, { piece: piece(), odd: random() < 0.5, v: random(), phase: random(), offset, radius, picture });
  const leaf = new Uint32Array(4);
  writeLeaf(leaf, 0, piece(), random() < 0.5, random(), random(), rotation(random), 0);
  return [...halves(card), ...halves(leaf)];
}

/** Texels of a grove's cards and leaves, all 32 bits of them. */
const texels: CheckProgram = {
  name: 'texels',
  fragment: texelFragment,
  defines: { GROVE: 1 },
  layers: 4,
  edges: [
    new Array<number>(16).fill(0),
    // The largest of each, at rest in the middle of the branch.
    [65535, 65535, 65535, 65535, 0, 0, 0, 0x3c03, 65535, 65535, 65535, 65535, 0x7fff, 0x8001, 0, 0x7fff],
  ],
  inputs: texelInputs,
  twin: (g) => {
    const card = cardTexel(wordsOf(g.slice(0, 8)), 0);
    const leaf = leafTexel(wordsOf(g.slice(8)), 0);
    const [inGrove, leafInGrove] = [groveLeaf(card.piece), groveLeaf(leaf.piece)];
    return [
      inGrove.piece + (card.odd ? 0.5 : 0),
      inGrove.tree,
      card.v,
      card.phase,
      ...card.offset,
      card.radius,
      leafInGrove.piece + (leaf.odd ? 0.5 : 0),
      card.picture + 10 * leafInGrove.tree,
      leaf.v,
      leaf.phase,
      ...leaf.orientation,
    ];
  },
  lines: [
    { name: 'cardTexel, piece, parity and tree', parts: [0, 1], tolerance: 0, note: 'integers: exact' },
    { name: 'cardTexel, place and phase', parts: [2, 3], tolerance: 1e-6, note: 'of 1, in 16 bits' },
    { name: 'cardTexel, offset and radius', parts: [4, 5, 6, 7], tolerance: 0, note: 'halves: exact' },
    { name: 'leafTexel, piece and parity', parts: [8], tolerance: 0, note: 'integers: exact' },
    { name: 'leafTree', parts: [9], tolerance: 0, note: 'integers, with the picture of the card: exact' },
    { name: 'leafTexel, place and phase', parts: [10, 11], tolerance: 1e-6, note: 'of 1, in 16 bits' },
    {
      name: 'leafTexel, orientation',
      parts: [12, 13, 14, 15],
      tolerance: 1e-6,
      note: 'of a unit quaternion, in 16 bits',
    },
  ],
};

/** The functions on trees of a forest: their views, how classes share them out, and what a texel of a grove says. */
export const forestPrograms: readonly CheckProgram[] = [octahedral, fade, texels];
