import type { WebGLRenderer } from 'three';
import { describe, expect, test } from 'vitest';
import { growPacked } from '../../src/core/pack/grow-packed.ts';
import { POSE_TARGETS } from '../../src/core/pack/layout.ts';
import { planeOf } from '../../src/core/wind/pose-plainly.ts';
import { DEFAULT_GUST, STILL, type Wind } from '../../src/core/wind/wind.ts';
import { CpuPoser } from '../../src/gpu/cpu-poser.ts';
import { TreeTextures } from '../../src/gpu/tree-textures.ts';
import { FeltWind } from '../../src/view/felt-wind.ts';
import { shippedSpecies } from '../core/pack/shipped-species.ts';
import { BEAUFORT_11, galeOf } from '../core/wind/some-winds.ts';

const species = shippedSpecies('quaking-aspen');
const tree = growPacked({ ...species, leaves: { ...species.leaves, count: 0 } }, 1, { levels: 3 }).packed;
const end = POSE_TARGETS.P3 * planeOf(tree.restPose);
const noRenderer = null as unknown as WebGLRenderer; // the CPU needs none

/** A tick of the clock that is no fraction of a step, and a moment: a thirtieth of a step. */
const FRAME = 1 / 60;
const MOMENT = FRAME / 30;

/** An edit as a page makes it: the wind that fades in from a time on. */
type Edit = readonly [time: number, wind: Wind, fade: number];

/**
 * The farthest that a tip goes in a moment beyond what its way in the frames around that moment says, metres, over ten seconds; and how
 * fast the fastest is. A motion, however quick, goes no way in no time; a pop does.
 */
function leaps(wind: Wind, edits: readonly Edit[] = []): { leap: number; fastest: number } {
  const felt = new FeltWind();
  const poser = new CpuPoser(new TreeTextures(tree, false));
  felt.set(wind, 0, 0);
  const tips = (time: number): Float32Array => {
    poser.update(noRenderer, time, felt);
    return poser.read(noRenderer).subarray(end, end + 4 * tree.pieceCount);
  };
  const apart = (a: Float32Array, b: Float32Array, i: number): number =>
    Math.hypot(a[4 * i] - b[4 * i], a[4 * i + 1] - b[4 * i + 1], a[4 * i + 2] - b[4 * i + 2]);
  let [leap, fastest] = [0, 0];
  const waiting = [...edits];
  let last = tips(2);
  for (let frame = 1; frame <= 600; frame++) {
    const time = 2 + frame * FRAME;
    const before = tips(time - MOMENT);
    const edit = waiting[0];
    if (edit && time >= 2 + edit[0]) {
      felt.set(edit[1], time - MOMENT, edit[2]);
      waiting.shift();
    }
    const now = tips(time);
    for (let i = 0; i < tree.pieceCount; i++) {
      const speed = apart(before, last, i) / (FRAME - MOMENT);
      fastest = Math.max(fastest, speed);
      leap = Math.max(leap, apart(now, before, i) - 2 * speed * MOMENT);
    }
    last = now;
  }
  return { leap, fastest };
}

/** Metres: what a tip may speed up by around a moment. */
const LEAP = 0.002;

/** Metres a second: a tip that turns over when the wind meets its end is faster, though it leaps nowhere. */
const FASTEST = 30;

describe('no tip leaps in ten seconds at Beaufort 11', () => {
  test.each(['direct', 'spring', 'sway'] as const)('%s', (model) => {
    const { leap, fastest } = leaps(galeOf(BEAUFORT_11, { model }));
    expect(leap).toBeLessThan(LEAP);
    expect(fastest).toBeGreaterThan(0.5);
    expect(fastest).toBeLessThan(FASTEST);
  });

  test('while models are switched, the wind turns and drops, and a gust is thrown', () => {
    const gale = galeOf(BEAUFORT_11);
    const gust = { ...DEFAULT_GUST, x: -16, start: 9, amplitude: 0.5 };
    const edits: Edit[] = [
      [1, { ...gale, model: 'direct' }, 0.4],
      [2, { ...gale, model: 'spring' }, 0.4],
      [3, { ...gale, model: 'sway' }, 1.2],
      [5, { ...gale, stiffness: 2, spring: { ...STILL.spring, damping: 0.05 } }, 1.2],
      [7, { ...gale, stiffness: 2, gusts: [gust] }, 0.4],
      [8, { ...gale, waves: gale.waves.map((wave) => ({ ...wave, direction: wave.direction + 2 })) }, 1.2],
      [8.5, { ...gale, strength: 0.2, zeroMean: true, profile: { ...STILL.profile, kind: 'log' } }, 0.4],
    ];
    const { leap, fastest } = leaps({ ...gale, model: 'spring' }, edits);
    expect(leap).toBeLessThan(LEAP);
    expect(fastest).toBeGreaterThan(0.5);
    expect(fastest).toBeLessThan(FASTEST);
  });
});
