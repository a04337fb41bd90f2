import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { grow } from '../../../src/core/grow/grow.ts';
import { cross, dot, length, subtract, unit, type Vec3 } from '../../../src/core/math/vec3.ts';
import { packTree } from '../../../src/core/pack/pack.ts';
import { attachLeaves } from '../../../src/core/pieces/attach-leaves.ts';
import { fitPieces } from '../../../src/core/pieces/fit-pieces.ts';
import { parseSpecies } from '../../../src/core/species/parse.ts';
import type { Species } from '../../../src/core/species/species.ts';
import { windStateAt } from '../../../src/core/wind/fade.ts';
import { planeOf, poseOf, poseTreePlainly } from '../../../src/core/wind/pose-plainly.ts';
import { poseTree } from '../../../src/core/wind/pose-tree.ts';
import { directWind } from './shipped-winds.ts';

/** Times in seconds that meet gusts and lulls. */
const TIMES = [0.7, 2.9, 4.4, 6.1, 8.3, 11.2, 13.9, 17];

/** The species without most of its leaves, which the wind pass does not know. */
function bare(name: string): Species {
  const species = parseSpecies(readFileSync(`public/species/${name}.json`, 'utf8')).species!;
  return { ...species, leaves: { ...species.leaves, count: Math.sign(species.leaves.count) } };
}

const middle = (values: number[]): number => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

describe.each(['quaking-aspen', 'black-tupelo', 'california-black-oak', 'weeping-willow'])('%s', (name) => {
  const tree = grow(bare(name), 1);
  const pieces = fitPieces(tree);
  const packed = packTree(tree, pieces, attachLeaves(tree, pieces));
  const plane = planeOf(packed.restPose);
  const lastOfStem = new Int32Array(tree.stems.count);
  for (let i = 0; i < pieces.count; i++) if (pieces.next[i] < 0) lastOfStem[pieces.stem[i]] = i;
  const poseIn = (wind: string, time: number) => poseTree(packed, windStateAt(directWind(wind), time), 'exact');

  /** Direction of a stem's tip seen from the frame at its base: what its own bend changes, and its parents' do not. */
  function tipOf(pose: Float32Array, stem: number): Vec3 {
    const { curve, o } = poseOf(pose, plane, pieces.firstOfStem[stem]);
    const { p2, p3 } = poseOf(pose, plane, lastOfStem[stem]).curve;
    const l = unit(subtract(curve.p1, curve.p0));
    const d = unit(subtract(p3, p2));
    return [dot(d, l), dot(d, o), dot(d, cross(l, o))];
  }

  /** Median over the stems of each level of the largest angle in degrees by which a stem bends. */
  function bends(wind: string): number[] {
    const step = Math.ceil(tree.stems.count / 1500);
    const stems = Array.from({ length: Math.floor(tree.stems.count / step) }, (_, i) => i * step);
    const most = stems.map(() => 0);
    const rest = stems.map((stem) => tipOf(packed.restPose.data, stem));
    for (const time of TIMES) {
      const pose = poseIn(wind, time);
      stems.forEach((stem, k) => {
        const d = tipOf(pose, stem);
        most[k] = Math.max(most[k], (Math.atan2(length(cross(d, rest[k])), dot(d, rest[k])) * 180) / Math.PI);
      });
    }
    const levels = Math.max(...tree.stems.level) + 1;
    return Array.from({ length: levels }, (_, level) =>
      middle(stems.flatMap((stem, k) => (tree.stems.level[stem] === level ? [most[k]] : []))),
    );
  }

  test('stands as it was grown when there is no wind', () => {
    const pose = poseIn('still', 3);
    let worst = 0;
    for (let i = 0; i < packed.pieceCount; i++) {
      const [a, b] = [poseOf(pose, plane, i), poseOf(packed.restPose.data, plane, i)];
      for (const p of ['p0', 'p1', 'p2', 'p3'] as const)
        worst = Math.max(worst, length(subtract(a.curve[p], b.curve[p])));
      worst = Math.max(worst, length(subtract(a.o, b.o)));
    }
    expect(worst).toBeLessThan(1e-4);
  });

  test('the fast pose is the plain one', () => {
    const wind = windStateAt(directWind('gale'), 4.4);
    const [a, b] = [poseTree(packed, wind, 'exact'), poseTreePlainly(packed, wind, 'exact')];
    let worst = 0;
    for (let i = 0; i < a.length; i++) worst = Math.max(worst, Math.abs(a[i] - b[i]));
    // Both round to float32 what the next depth reads: a few millionths of a metre at 20 m.
    expect(worst).toBeLessThan(5e-5);
  });

  test('in a breeze the trunk hardly moves, branches bend by a few degrees, twigs the most', () => {
    const [trunk, branch, twig, finest = twig] = bends('breeze');
    expect(trunk).toBeLessThan(2.5);
    expect(branch).toBeGreaterThan(1.7 * trunk);
    expect(branch).toBeLessThan(11);
    expect(twig).toBeGreaterThan(branch);
    expect(twig).toBeGreaterThan(4);
    expect(twig).toBeLessThan(20);
    expect(finest).toBeLessThan(35);
  });

  test('a gale bends it two to nine times as far as a breeze', () => {
    const [breeze, gale] = [bends('breeze'), bends('gale')];
    for (let level = 0; level < breeze.length; level++) {
      expect(gale[level] / breeze[level]).toBeGreaterThan(2.2);
      expect(gale[level] / breeze[level]).toBeLessThan(9);
      expect(gale[level]).toBeLessThan(80);
    }
  });

  test('a storm is seen at a glance: the top of the trunk leans, limbs stream, twigs lie in the wind', () => {
    const [trunk, branch, twig] = bends('storm');
    expect(trunk).toBeGreaterThan(9);
    expect(trunk).toBeLessThan(25);
    expect(branch).toBeGreaterThan(27);
    expect(branch).toBeLessThan(65);
    expect(twig).toBeGreaterThan(0.9 * branch);
    expect(twig).toBeLessThan(80);
  });
});
